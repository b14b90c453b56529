#pragma once
// CASE/landmarks.json: nasion, inion and tragi of the case's scalp, with their errors and origins. Landmarks
// set by a person are kept when the others are searched again.

#include <filesystem>
#include <optional>

#include "facenav/surface/scalp_landmarks.h"

namespace facenav::casefile {

/// Writes the whole file, 0600.
void writeLandmarks(const surface::ScalpLandmarks& landmarks, const std::filesystem::path& case_folder);
/// Reads the landmarks; nothing if the case has none yet. Throws Error naming file and key.
std::optional<surface::ScalpLandmarks> readLandmarks(const std::filesystem::path& case_folder);

}  // namespace facenav::casefile
