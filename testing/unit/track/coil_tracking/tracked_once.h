#pragma once
// Print of the default coil, and a tracker's answer for a single stereo pair.

#include <opencv2/aruco.hpp>

#include "coil_scene.h"
#include "facenav/coil_tracking/coil_tracker.h"

namespace facenav::coil_tracking::testing {

/// The print of the default coil's marker.
inline Print id7() { return arucoPrint(cv::aruco::DICT_4X4_50, 7); }

inline Tracked<CoilPose> trackOnce(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                                   const CoilModel& coil = defaultCoil()) {
  const auto tracker = makeMarkerCoilTracker();
  tracker->start(rig, coil);
  return tracker->track(frame);
}

}  // namespace facenav::coil_tracking::testing
