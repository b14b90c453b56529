#pragma once
// RigObserver: turns the trackers' measurements in a frame into an observation of the cameras
// (health/observation.h). Features of the face are matched again without use of the epipolar line.

#include "facenav/cameras/stereo_frame.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/head_tracking/head_tracker.h"
#include "facenav/health/observation.h"

namespace facenav::monitoring {

/// Largest motion of the head between the exposures at which stereo is trusted: more
/// would look like a rotation of the camera, and the dense measurement turns it into five times as much
/// depth.
constexpr double kMostBetweenExposures_mm = 0.1;

class RigObserver {
 public:
  /// Makes the observation of a frame; call it for each frame in turn.
  health::RigObservation observe(const cameras::StereoFrame& frame,
                                 const Tracked<head_tracking::HeadPose>& head,
                                 const coil_tracking::CoilResult& coil);

 private:
  std::size_t frames_ = 0, next_feature_ = 0;
};

}  // namespace facenav::monitoring
