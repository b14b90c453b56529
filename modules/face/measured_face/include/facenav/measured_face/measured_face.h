#pragma once
// The face as the cameras measure it, without a scan: from one pair of images, with dots or without, or fused
// from several frames of a film by the head's motion. Camera frame of the (first) frame, mm.

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "facenav/capture/frame_source.h"
#include "facenav/core/task_monitor.h"
#include "facenav/measured_face/face_in_space.h"
#include "facenav/stereo/cloud_fusion.h"

namespace facenav::measured_face {

// Frames measured of a film, each in some tenths of a second: for a cloud to look at, and for an alignment.
// More add little.
constexpr int kFramesOfACloud = 40, kFramesToAlign = 12;

struct MeasuredFace {
  stereo::FusedCloud cloud;
  FaceInSpace landmarks;  // of the (first) frame
  std::shared_ptr<const cameras::StereoFrame> first;
  int fused = 1, lost = 0;  // frames
};

/// One pair. `plain`: the images in which the face is searched; the same as `measured` if there are no dots.
/// Throws Error as stereo::measureFace does, and if no point of a face was found.
MeasuredFace measurePair(const cameras::StereoRig& rig, const cameras::StereoFrame& measured,
                         const cameras::StereoFrame& plain, bool has_dots, const face::FaceDetector& detector,
                         TaskMonitor& monitor);

/// Motion of the face since the first frame that it was given; nothing where the face is lost. It is called
/// with each frame of a film in turn (head_tracking::motionSinceFirst).
using FaceMotion =
    std::function<std::optional<RigidTransform<Camera, Head>>(const cameras::StereoFrame& frame)>;

/// Fuses the film's frames `first` to `last` (both included). Frames in
/// which the face is lost or cannot be measured are left out and counted. Of a long film, some `most` evenly
/// spaced frames are measured. Throws Error: no such frame, no face in the first.
MeasuredFace measureFilm(capture::FrameSource& film, std::int64_t first, std::int64_t last,
                         const FaceMotion& motion, const face::FaceDetector& detector, TaskMonitor& monitor,
                         int most = kFramesOfACloud);

}  // namespace facenav::measured_face
