#include "parameter_steps.h"

#include <cmath>

#include "facenav/cameras/rig_motion.h"
#include "facenav/geometry/normal_equations.h"

namespace facenav::cameras {

Eigen::MatrixXd principalSteps(const cv::Mat& matrix) {
  constexpr double kNone = 1e-6;  // smallest variance of a scaled axis: less is rounding
  Eigen::MatrixXd covariance(matrix.rows, matrix.rows);
  for (int i = 0; i < matrix.rows; ++i)
    for (int j = 0; j < matrix.rows; ++j) covariance(i, j) = matrix.at<double>(i, j);
  const Eigen::VectorXd scale = covariance.diagonal().cwiseMax(1e-30).cwiseSqrt();
  const Eigen::MatrixXd scaled =
      scale.cwiseInverse().asDiagonal() * covariance * scale.cwiseInverse().asDiagonal();
  const auto axes = principalAxes(scaled);
  Eigen::VectorXd lengths = axes.values.cwiseMax(0).cwiseSqrt();
  for (double& length : lengths)
    if (length < kNone) length = 0;
  return scale.asDiagonal() * axes.vectors * lengths.asDiagonal();
}

StereoRig stepped(const StereoRig& rig, const Eigen::VectorXd& step) {
  int at = 0;
  StereoRig other = turned(rig, step.tail<6>());
  for (CameraModel* camera : {&other.left, &other.right}) {
    camera->k(0, 0) += step[at++];
    camera->k(1, 1) += step[at++];
    camera->k(0, 2) += step[at++];
    camera->k(1, 2) += step[at++];
    camera->distortion = camera->distortion.clone();
    for (int i = 0; i < int(camera->distortion.total()); ++i) camera->distortion.at<double>(i) += step[at++];
  }
  return other;
}

}  // namespace facenav::cameras
