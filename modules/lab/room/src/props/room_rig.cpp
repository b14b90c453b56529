#include "facenav/room/room_rig.h"

#include <cmath>
#include <random>

#include "facenav/geometry/rotation.h"

namespace facenav::room {
namespace {

Eigen::Matrix3d turn(double degrees, const Eigen::Vector3d& axis) {
  return expRotation(degrees * kRadPerDeg * axis);
}

cameras::CameraModel camera(const RigOptions& options, double focal_scale, double dx_px, double dy_px,
                            double bend) {
  cameras::CameraModel model;
  const double f = options.focal_px * focal_scale;
  model.k = cv::Matx33d(f, 0, 0.5 * (options.width_px - 1) + dx_px, 0, 1.0015 * f,
                        0.5 * (options.height_px - 1) + dy_px, 0, 0, 1);
  model.distortion = (cv::Mat_<double>(1, 5) << bend * options.k1, bend * options.k2, bend * options.p1,
                      -bend * options.p2, options.k3);
  return model;
}

Eigen::Isometry3d placed(const Eigen::Matrix3d& rotation, double x_mm) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation;
  pose.translation().x() = x_mm;
  return pose;
}

}  // namespace

RigOptions closeRig() {
  RigOptions rig;
  rig.width_px = rig.height_px = 1024;
  rig.focal_px = 1550.0;
  rig.baseline_mm = 114.0;
  rig.convergence_deg = 20.0;
  return rig;
}

RigOptions randomRig(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&random](double low, double high) {
    return low + (high - low) * double(random() >> 11) * 0x1p-53;
  };
  constexpr double kHead_mm = 600.0;
  RigOptions rig;
  rig.focal_px = uniform(600.0, 1000.0);
  rig.baseline_mm = uniform(60.0, 200.0);
  rig.roll_deg = uniform(-20.0, 20.0);
  rig.convergence_deg = uniform(0.5, 1.0) * 2.0 * std::atan2(0.5 * rig.baseline_mm, kHead_mm) / kRadPerDeg;
  rig.k1 = uniform(-0.28, 0.06);
  rig.k2 = -0.5 * rig.k1 + uniform(-0.03, 0.03);
  rig.p1 = uniform(-0.001, 0.001);
  rig.p2 = uniform(-0.001, 0.001);
  return rig;
}

cameras::StereoRig makeRig(const RigOptions& options) {
  const double half_deg = 0.5 * options.convergence_deg, half_mm = 0.5 * options.baseline_mm;
  const auto middle_T_left =
      placed(turn(half_deg, Eigen::Vector3d::UnitY()) * turn(0.35, Eigen::Vector3d::UnitZ()), -half_mm);
  const auto middle_T_right =
      placed(turn(-half_deg, Eigen::Vector3d::UnitY()) * turn(-0.25, Eigen::Vector3d::UnitZ()) *
                 turn(0.2, Eigen::Vector3d::UnitX()),
             half_mm);
  cameras::StereoRig rig;
  rig.width_px = options.width_px;
  rig.height_px = options.height_px;
  rig.left = camera(options, 1.0, 6.3, -4.2, 1.0);
  rig.right = camera(options, 0.9925, -5.1, 3.4, 0.9);
  rig.right_T_left =
      RigidTransform<RightCamera, Camera>::fromIsometry(middle_T_right.inverse() * middle_T_left);
  return rig;
}

RigidTransform<Camera, Room> cameraFromRoom(const cameras::StereoRig& rig, double roll_deg) {
  const Eigen::Isometry3d left_T_right = rig.right_T_left.inverse().isometry();
  const Eigen::Matrix3d mean = expRotation(0.5 * logRotation(left_T_right.linear()));
  Eigen::Isometry3d camera_T_room = Eigen::Isometry3d::Identity();
  camera_T_room.linear() = mean * turn(-roll_deg, Eigen::Vector3d::UnitZ());
  camera_T_room.translation() = 0.5 * left_T_right.translation();
  return RigidTransform<Camera, Room>::fromIsometry(camera_T_room);
}

cameras::ProjectorModel roomProjector(const RigidTransform<Camera, Room>& camera_T_room) {
  constexpr double kFocal_px = 1400.0;
  cameras::ProjectorModel projector;
  projector.width_px = 1024, projector.height_px = 768;
  projector.lens.k = cv::Matx33d(kFocal_px, 0, 0.5 * (projector.width_px - 1), 0, kFocal_px,
                                 0.5 * (projector.height_px - 1), 0, 0, 1);
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.translation() = Eigen::Vector3d(5.0, -70.0, 20.0);
  place.linear() = Eigen::AngleAxisd(-0.12, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const auto room_T_projector = RigidTransform<Room, Projector>::fromIsometry(place);
  projector.projector_T_camera = room_T_projector.inverse() * camera_T_room.inverse();
  return projector;
}

}  // namespace facenav::room
