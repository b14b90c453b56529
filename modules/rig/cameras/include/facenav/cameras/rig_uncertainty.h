#pragma once
// RigUncertainty: the calibration's uncertainty as rigs one standard deviation away. Also the epipolar
// residual of a pair of pixels under a rig.

#include <vector>

#include "facenav/cameras/stereo_rig.h"

namespace facenav::cameras {

/// Rigs one standard deviation away along independent directions. The covariance of anything computed from
/// the rig is the sum of the squares of its changes.
struct RigUncertainty {
  std::vector<StereoRig> one_sigma;
  double lens_px = 0.05;  // misfit of the lens model in one place of the image
};
/// Takes the rig's own covariance. Without one, typical values for its rms_px (0.2 px if unknown).
RigUncertainty uncertaintyOf(const StereoRig& rig);

/// Signed distance (px) of the right pixel from the epipolar line of the left one, positive on the side to
/// which the right image moves when it is moved down in a level rig.
double epipolarResidual_px(const StereoRig& rig, const Eigen::Vector2d& left_px,
                           const Eigen::Vector2d& right_px);

}  // namespace facenav::cameras
