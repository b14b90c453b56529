#pragma once
// Errors in mm and degrees of measurements at the head, from a calibration's covariance.

#include "facenav/cameras/head_effect.h"
#include "facenav/cameras/stereo_rig.h"

namespace facenav::cameras {

/// `middle_mm`: middle of the head in Camera. One standard deviation each; zeros when the rig has no
/// covariance.
HeadEffect effectAtHead(const StereoRig& rig, const Eigen::Vector3d& middle_mm);

}  // namespace facenav::cameras
