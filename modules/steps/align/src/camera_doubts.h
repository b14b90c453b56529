#pragma once
// Diagnoses a failed or doubtful alignment: moved cameras, unsynchronised images, projector off. Camera
// frame, mm.

#include <functional>
#include <optional>
#include <string>

#include "facenav/align/align_from_capture.h"
#include "facenav/capture/recording.h"
#include "facenav/core/error.h"
#include "facenav/stereo/face_cloud.h"

namespace facenav::steps {

/// Runs `task` and returns its error if another way may help. Errors that no other way avoids are rethrown: a
/// fault of the cameras, and the user's stop.
std::optional<Error> errorOf(const std::function<void()>& task);

/// Throws the reason of a failed alignment. Checks the cameras first, then the dots (if `from` needs them).
/// If all are in order, throws the original error, as NotMeasured if the face was not even measured.
[[noreturn]] void refuseAlignment(const cameras::StereoRig& rig, const capture::CapturePair& capture,
                                  measured_face::AlignedFrom from, const Error& error, bool is_measured,
                                  const std::string& matcher);

}  // namespace facenav::steps
