#pragma once
// The head's true pose as cameras with a calibration measure it. A calibration is never exact: it shifts and
// turns whatever is measured at one place, head and coil alike. What a tool can be blamed for is the rest.

#include "facenav/cameras/stereo_rig.h"

namespace facenav::app {

/// The pose that exact matches in the pictures of `truth` would give with the calibration `used`.
/// `middle_mm`: the head's middle, Mri.
Eigen::Isometry3d poseAsMeasured(const cameras::StereoRig& truth, const cameras::StereoRig& used,
                                 const Eigen::Isometry3d& camera_T_mri, const Eigen::Vector3d& middle_mm);

/// Size of the head as measured with the calibration `used`, relative to its true size.
double sizeAsMeasured(const cameras::StereoRig& truth, const cameras::StereoRig& used,
                      const Eigen::Isometry3d& camera_T_mri, const Eigen::Vector3d& middle_mm);

}  // namespace facenav::app
