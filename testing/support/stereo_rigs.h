#pragma once
// Camera rigs for tests: a converging pair like the room's, a vertical one, a rolled one, and one with all
// coefficients of OpenCV's distortion model.

#include <initializer_list>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/rotation.h"

namespace facenav::testing {

inline cv::Mat distortion(std::initializer_list<double> values) {
  return cv::Mat(cv::Mat_<double>(values)).reshape(1, 1).clone();
}

inline cv::Matx33d cameraMatrix(double f_px, double cx_px, double cy_px) {
  return {f_px, 0, cx_px, 0, f_px * 1.001, cy_px, 0, 0, 1};
}

/// Rig of 640 x 480, f 800 px, baseline 120 mm, converging by 10 degrees on a point 600 mm away.
inline cameras::StereoRig convergingRig() {
  cameras::StereoRig rig;
  rig.width_px = 640;
  rig.height_px = 480;
  rig.left = {cameraMatrix(800, 322.3, 238.1), distortion({-0.21, 0.11, 0.0007, -0.0004, 0.02})};
  rig.right = {cameraMatrix(806, 317.9, 243.4), distortion({-0.19, 0.08, -0.0003, 0.0006, 0.01})};
  const Eigen::Matrix3d r = expRotation({0.004, 10.0 * M_PI / 180, -0.006});
  const Eigen::Vector3d centre_mm(119.5, 1.2, 10.5);
  rig.right_T_left = {Eigen::Quaterniond(r), -r * centre_mm};
  return rig;
}

/// Rig of the same cameras, with the second one above the first.
inline cameras::StereoRig verticalRig() {
  cameras::StereoRig rig = convergingRig();
  const Eigen::Matrix3d r = expRotation({10.0 * M_PI / 180, 0.01, 0.008});
  rig.right_T_left = {Eigen::Quaterniond(r), -r * Eigen::Vector3d(2.0, -119.5, 10.5)};
  return rig;
}

/// Converging rig with both cameras rolled about their axes by 30 and 38 degrees.
inline cameras::StereoRig rolledRig() {
  cameras::StereoRig rig = convergingRig();
  const Eigen::Isometry3d left_roll(expRigid((Vector6d() << 0, 0, 30 * M_PI / 180, 0, 0, 0).finished()));
  const Eigen::Isometry3d right_roll(expRigid((Vector6d() << 0, 0, 38 * M_PI / 180, 0, 0, 0).finished()));
  rig.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(
      right_roll * rig.right_T_left.isometry() * left_roll.inverse());
  return rig;
}

inline cameras::StereoRig fullyDistortedRig() {
  cameras::StereoRig rig = convergingRig();
  rig.left.distortion = distortion(
      {-0.2, 0.1, 0.001, -0.002, 0.03, 0.05, -0.02, 0.01, 0.002, -0.001, 0.0015, 0.0008, 0.01, -0.02});
  rig.right.distortion = distortion({0.1, -0.05, 0.001, 0.001, 0.01, 0.15, -0.08, 0.02});
  return rig;
}

/// Crops a rig to the central 320 x 240 pixels: the same pixel size, a quarter of the work.
inline cameras::StereoRig cropped(cameras::StereoRig rig) {
  for (cameras::CameraModel* camera : {&rig.left, &rig.right}) {
    camera->k(0, 2) -= 160;
    camera->k(1, 2) -= 120;
  }
  rig.width_px = 320;
  rig.height_px = 240;
  return rig;
}

}  // namespace facenav::testing
