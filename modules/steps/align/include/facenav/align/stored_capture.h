#pragma once
// The capture pair of an alignment, stored in the case (alignment_capture/). A later recording without a
// capture of its own is tracked against the face as it was at the alignment.

#include <filesystem>
#include <optional>

#include "facenav/capture/recording.h"
#include "facenav/casefile/file_group.h"

namespace facenav::steps {

/// Writes into a group of the case's files. These are photographs of the patient's face: private from the
/// first byte.
void writeStoredCapture(const casefile::FileGroup& group, const cameras::StereoRig& rig,
                        const capture::CapturePair& pair);
/// Reads the pair; nothing if there is none. Throws Error if it was taken with another rig than `rig`: the
/// alignment is then not valid for these cameras.
std::optional<capture::CapturePair> readStoredCapture(const std::filesystem::path& case_folder,
                                                      const cameras::StereoRig& rig);

}  // namespace facenav::steps
