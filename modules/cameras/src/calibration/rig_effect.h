#pragma once
// What a calibration's covariance means where the head will be: errors in mm and degrees of what the rig
// measures there.

#include "facenav/cameras/head_effect.h"
#include "facenav/cameras/stereo_rig.h"

namespace facenav::cameras {

/// `middle_mm`: Camera, the middle of the head. One standard deviation each; zeros where the rig has no
/// covariance.
HeadEffect effectAtHead(const StereoRig& rig, const Eigen::Vector3d& middle_mm);

}  // namespace facenav::cameras
