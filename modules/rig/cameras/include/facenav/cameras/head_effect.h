#pragma once
// HeadEffect: the errors in mm and degrees at the head that follow from a calibration's standard errors.

#include "facenav/cameras/stereo_rig.h"

namespace facenav::cameras {

/// One standard deviation, from the rig's covariance, of measurements at the mean position of the boards.
struct HeadEffect {
  double distance_mm = 0;  // distance from the left camera
  double point_mm = 0;     // error of a point's position in Camera
  double depth_mm = 0;     // error of a point's distance; the rest of point_mm rotates all points alike
  double length_mm = 0;    // error of a length of 100 mm
  double motion_mm = 0, motion_deg = 0;  // error for a face moved by 20 mm and turned by 5 deg
};

/// Effect at the head, one standard deviation each; zeros if the rig has no covariance. `middle_mm`: middle
/// of the head in Camera.
HeadEffect effectAtHead(const StereoRig& rig, const Eigen::Vector3d& middle_mm);

}  // namespace facenav::cameras
