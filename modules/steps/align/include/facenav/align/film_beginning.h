#pragma once
// The first seconds of a recording's film: the face while the head turns to both sides, and the coil's marker
// at rest.

#include <utility>
#include <vector>

#include "facenav/align/known_lengths.h"
#include "facenav/capture/recording.h"
#include "facenav/face/face_landmarks.h"

namespace facenav::steps {

/// Frame numbers of the beginning, first and last (both included). With `detector` it begins with the first
/// frame in which both cameras see a face, if one of the first seconds does.
std::pair<std::int64_t, std::int64_t> beginningOf(const capture::Recording& recording,
                                                  const face::FaceDetector* detector = nullptr);

/// Measures the coil's marker while it rests there; nothing without a film.
std::optional<health::ScaleObservation> restingMarkerIn(const capture::Recording& recording,
                                                        const coil_tracking::CoilModel& coil,
                                                        coil_tracking::CoilTracker& tracker);

/// Returns the coil of the first folder with a coil.json; else the one of the default marker.
coil_tracking::CoilModel coilNamedIn(const std::vector<std::filesystem::path>& folders);

}  // namespace facenav::steps
