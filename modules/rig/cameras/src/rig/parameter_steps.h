#pragma once
// A rig within the uncertainty of its calibration: one step along each principal axis of the covariance.

#include <Eigen/Core>

#include "facenav/cameras/stereo_rig.h"

namespace facenav::cameras {

/// Steps of one standard deviation: a column per principal axis, a row per parameter (order: StereoRig). The
/// parameters are scaled to similar size before the axes are found. Axes without any variance (a tangential
/// distortion held at 0) give columns of zeros. `covariance`: square, CV_64F.
Eigen::MatrixXd principalSteps(const cv::Mat& covariance);

/// The rig after a step of its parameters, in the order of the covariance; the last six are an increment of
/// right_T_left (rotation rad, translation mm).
StereoRig stepped(const StereoRig& rig, const Eigen::VectorXd& step);

}  // namespace facenav::cameras
