#pragma once
// MeasuredFace: the face as measured by the cameras, without a scan. Source: one pair of images, with dots or
// without, or several frames of a film, fused by the head's motion. Frame: Camera at the (first) frame, mm.

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "facenav/capture/frame_source.h"
#include "facenav/core/task_monitor.h"
#include "facenav/measured_face/face_in_space.h"
#include "facenav/stereo/cloud_fusion.h"

namespace facenav::measured_face {

// Frames of a film that are measured, some tenths of a second each: for a cloud to view, and for an
// alignment. More add little.
constexpr int kFramesOfACloud = 40, kFramesToAlign = 12;

struct MeasuredFace {
  stereo::FusedCloud cloud;
  FaceInSpace landmarks;  // in the (first) frame
  std::shared_ptr<const cameras::StereoFrame> first;
  int fused = 1, lost = 0;  // number of frames fused, and lost
};

/// Measures one pair. `plain`: the images in which the face is searched; the same as `measured` without dots.
/// Throws Error as stereo::measureFace, and if no point of a face was found.
MeasuredFace measurePair(const cameras::StereoRig& rig, const cameras::StereoFrame& measured,
                         const cameras::StereoFrame& plain, bool has_dots, const face::FaceDetector& detector,
                         TaskMonitor& monitor);

/// Returns the face's motion since the first frame, or nothing if the face is lost. It is called with each
/// frame of a film in turn (head_tracking::motionSinceFirst).
using FaceMotion =
    std::function<std::optional<RigidTransform<Camera, Head>>(const cameras::StereoFrame& frame)>;

/// Fuses the film's frames `first` to `last` (both included). Frames in which the face is lost or cannot be
/// measured are left out and counted. At most about `most` evenly spaced frames are measured. Throws Error if
/// there is no such frame, or no face in the first.
MeasuredFace measureFilm(capture::FrameSource& film, std::int64_t first, std::int64_t last,
                         const FaceMotion& motion, const face::FaceDetector& detector, TaskMonitor& monitor,
                         int most = kFramesOfACloud);

}  // namespace facenav::measured_face
