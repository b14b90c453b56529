#pragma once
// HeadEffect: the errors in mm and degrees at the head that follow from a calibration's standard errors.

#include "facenav/cameras/stereo_rig.h"

namespace facenav::cameras {

/// One standard deviation, by the rig's covariance, of measurements at the mean position of the boards.
struct HeadEffect {
  double distance_mm = 0;  // from the left camera
  double point_mm = 0;     // of a point's position in Camera
  double depth_mm = 0;     // of a point's distance; the rest of point_mm rotates all points alike
  double length_mm = 0;    // of 100 mm
  double motion_mm = 0, motion_deg = 0;  // of a face moved by 20 mm and turned by 5 deg
};

/// `middle_mm`: middle of the head in Camera. One standard deviation each; zeros when the rig has no
/// covariance.
HeadEffect effectAtHead(const StereoRig& rig, const Eigen::Vector3d& middle_mm);

}  // namespace facenav::cameras
