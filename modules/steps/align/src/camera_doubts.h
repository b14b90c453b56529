#pragma once
// Diagnoses a failed or doubtful alignment: moved cameras, unsynchronised images, projector off. Camera
// frame, mm.

#include <exception>
#include <functional>
#include <optional>
#include <string>

#include "facenav/align/align_from_capture.h"
#include "facenav/capture/recording.h"
#include "facenav/core/error.h"
#include "facenav/face/face_landmarks.h"
#include "facenav/stereo/face_cloud.h"

namespace facenav::steps {

/// Runs `task` and returns its Error if another way may help; nullptr: none. Errors that no other way avoids
/// are rethrown: a fault of the cameras, and the user's stop.
std::exception_ptr failureOf(const std::function<void()>& task);

/// The words of an Error.
std::string wordsOf(const std::exception_ptr& failure);

/// Throws the reason of a failed alignment. Checks the cameras first, then the dots (if `from` needs them).
/// `face`: in the left picture, if it was found; only matches there speak about the cameras. If all are in
/// order, throws the original error; as NotMeasured if no face was found and measured, since a surface that
/// may be anything does not speak against the person.
[[noreturn]] void refuseAlignment(const cameras::StereoRig& rig, const capture::CapturePair& capture,
                                  measured_face::AlignedFrom from, const std::exception_ptr& failure,
                                  bool is_measured, const std::string& matcher,
                                  const std::optional<face::FaceLandmarks>& face);

}  // namespace facenav::steps
