#include <cmath>

#include "facenav/cameras/rig_motion.h"
#include "facenav/cameras/rig_uncertainty.h"
#include "parameter_steps.h"

namespace facenav::cameras {
namespace {

// Not all errors of a calibration are noise: the board is not flat, the lens is not a polynomial.
constexpr double kInflation = 1.5;
// Misfit of the lens model in one place of the image, as a fraction of the reprojection rms. A larger value
// is the safe direction.
constexpr double kLensShare = 0.25;

StereoRig withTurn(const StereoRig& rig, const Eigen::Vector3d& turn_rad) {
  Vector6d motion = Vector6d::Zero();
  motion.head<3>() = turn_rad;
  return turned(rig, motion);
}

RigUncertainty fromCovariance(const StereoRig& rig) {
  RigUncertainty uncertainty;
  uncertainty.lens_px = kLensShare * rig.rms_px.value_or(0.2);
  const Eigen::MatrixXd steps = kInflation * principalSteps(rig.covariance);
  for (int axis = 0; axis < steps.cols(); ++axis)
    if (!steps.col(axis).isZero(0)) uncertainty.one_sigma.push_back(stepped(rig, steps.col(axis)));
  return uncertainty;
}

}  // namespace

RigUncertainty uncertaintyOf(const StereoRig& rig) {
  if (!rig.covariance.empty()) return fromCovariance(rig);
  // Uses typical errors after some twelve views of a board, in the images: 0.7 rms across the epipolar lines,
  // 0.02 deg of roll, 0.1 % of scale from focal lengths and yaw, and lens errors that grow towards the
  // corners.
  const double scale = rig.rms_px.value_or(0.2) / 0.2, f = rig.right.k(0, 0);
  RigUncertainty uncertainty;
  uncertainty.lens_px = kLensShare * 0.2 * scale;
  const auto add = [&](const StereoRig& other) { uncertainty.one_sigma.push_back(other); };
  add(withTurn(rig, {0.1 * scale / f, 0, 0}));
  add(withTurn(rig, {0, 0.05 * scale / f, 0}));
  add(withTurn(rig, {0, 0, 2.6e-4 * scale}));
  for (CameraModel StereoRig::*side : {&StereoRig::left, &StereoRig::right}) {
    StereoRig focal = rig, bent = rig;
    (focal.*side).k(0, 0) *= 1 + 3e-4 * scale;
    (focal.*side).k(1, 1) *= 1 + 3e-4 * scale;
    CameraModel& lens = bent.*side;
    lens.distortion = lens.distortion.empty() ? cv::Mat::zeros(1, 5, CV_64F) : lens.distortion.clone();
    lens.distortion.at<double>(0) += 1e-3 * scale;
    add(focal);
    add(bent);
  }
  for (int axis = 0; axis < 3; ++axis) {
    Vector6d shift = Vector6d::Zero();
    shift[3 + axis] = 0.04 * scale;
    add(turned(rig, shift));
  }
  return uncertainty;
}

double epipolarResidual_px(const StereoRig& rig, const Eigen::Vector2d& left_px,
                           const Eigen::Vector2d& right_px) {
  const Eigen::Vector3d point_mm = triangulate(rig, left_px, right_px).mm;
  if (!point_mm.allFinite() || point_mm.z() <= 0) return std::nan("");
  // The epipolar line near the right pixel: position and direction of the left pixel's ray at the point's
  // depth.
  const Eigen::Vector3d ray = undistort(rig.left, left_px).homogeneous();
  Eigen::Matrix<double, 2, 3> by_point;
  const Eigen::Vector3d in_right_mm = rig.right_T_left.isometry() * (ray * point_mm.z());
  if (in_right_mm.z() <= 0) return std::nan("");
  const Eigen::Vector2d on_line = project(rig.right, in_right_mm, by_point);
  const Eigen::Vector2d along = (by_point * (rig.right_T_left.rotation() * ray)).normalized();
  return Eigen::Vector2d(-along.y(), along.x()).dot(right_px - on_line);
}

}  // namespace facenav::cameras
