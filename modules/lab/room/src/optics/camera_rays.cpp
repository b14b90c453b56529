#include "camera_rays.h"

#include <algorithm>
#include <cmath>

namespace facenav::room {
namespace {

std::vector<Eigen::Vector2d> undistortAll(const cameras::CameraModel& camera, int width, int height) {
  std::vector<Eigen::Vector2d> table;
  table.reserve(std::size_t(width + 2) * std::size_t(height + 2));
  for (int y = -1; y <= height; ++y)
    for (int x = -1; x <= width; ++x) table.push_back(cameras::undistort(camera, {double(x), double(y)}));
  return table;
}

}  // namespace

CameraRays::CameraRays(const cameras::CameraModel& camera, int width_px, int height_px,
                       const Eigen::Isometry3d& camera_T_world)
    : camera_(camera),
      width_px_(width_px),
      height_px_(height_px),
      camera_T_world_(camera_T_world),
      world_from_camera_(camera_T_world.linear().transpose()),
      origin_mm_(camera_T_world.inverse().translation()),
      table_(undistortAll(camera, width_px, height_px)) {}

void CameraRays::moveTo(const Eigen::Isometry3d& camera_T_world) {
  camera_T_world_ = camera_T_world;
  world_from_camera_ = camera_T_world.linear().transpose();
  origin_mm_ = camera_T_world.inverse().translation();
}

bool CameraRays::shows(const Eigen::Vector3d& p_world_mm) const {
  const Eigen::Vector3d p = camera_T_world_ * p_world_mm;
  if (p.z() <= 0.0 || p.head<2>().norm() > 1.2 * p.z()) return false;
  const Eigen::Vector2d pixel = cameras::project(camera_, p);
  return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= width_px_ - 1.0 &&
         pixel.y() <= height_px_ - 1.0;
}

std::optional<cv::Rect> CameraRays::boxOf(const Eigen::AlignedBox3d& box,
                                          const Eigen::Isometry3d& world_T_object) const {
  constexpr double kWidest = 1.2, kMargin_px = 4.0;  // beyond ~50 deg the distortion model is not valid
  const Eigen::Isometry3d camera_T_object = camera_T_world_ * world_T_object;
  Eigen::AlignedBox2d around;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d p = camera_T_object * box.corner(Eigen::AlignedBox3d::CornerType(corner));
    if (p.z() < 1.0 || p.head<2>().norm() > kWidest * p.z()) return std::nullopt;
    around.extend(cameras::project(camera_, p));
  }
  const Eigen::Vector2d low = around.min().array() - kMargin_px,
                        size = around.sizes().array() + 2.0 * kMargin_px;
  return cv::Rect(int(std::floor(low.x())), int(std::floor(low.y())), int(std::ceil(size.x())),
                  int(std::ceil(size.y())));
}

Eigen::Vector3d CameraRays::direction(double x_px, double y_px) const {
  const double x = std::clamp(x_px + 1.0, 0.0, width_px_ + 0.999),
               y = std::clamp(y_px + 1.0, 0.0, height_px_ + 0.999);
  const int column = int(x), row = int(y), stride = width_px_ + 2;
  const double fx = x - column, fy = y - row;
  const Eigen::Vector2d* cell = &table_[std::size_t(row) * stride + column];
  const Eigen::Vector2d ray =
      (1 - fy) * ((1 - fx) * cell[0] + fx * cell[1]) + fy * ((1 - fx) * cell[stride] + fx * cell[stride + 1]);
  return world_from_camera_ * ray.homogeneous();
}

}  // namespace facenav::room
