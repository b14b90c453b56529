#pragma once
// CameraRays: the viewing ray of any image position of one camera, with distortion. Undistorted coordinates
// are tabulated at pixel centres (Newton on the distortion model, < 1e-9 px) and interpolated linearly
// between them; the error of that is below 1e-5 px.

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "facenav/cameras/stereo_rig.h"

namespace facenav::room {

class CameraRays {
 public:
  /// `camera_T_world` maps world (= left camera) to this camera.
  CameraRays(const cameras::CameraModel& camera, int width_px, int height_px,
             const Eigen::Isometry3d& camera_T_world);

  /// Moves the camera on its mount.
  void moveTo(const Eigen::Isometry3d& camera_T_world);

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }
  const Eigen::Vector3d& origin_mm() const { return origin_mm_; }
  /// Direction in the world, with z = 1 in the camera frame, so that the distance along it is the depth. x, y
  /// may lie up to half a pixel outside the image.
  Eigen::Vector3d direction(double x_px, double y_px) const;
  /// True if a world point is inside the image.
  bool shows(const Eigen::Vector3d& p_world_mm) const;
  /// Pixels in which a box (in its own frame, at `world_T_object`) can appear. nullopt if that cannot be
  /// determined, because the box reaches too far behind or beside the camera.
  std::optional<cv::Rect> boxOf(const Eigen::AlignedBox3d& box,
                                const Eigen::Isometry3d& world_T_object) const;
  const cameras::CameraModel& camera() const { return camera_; }
  const Eigen::Isometry3d& camera_T_world() const { return camera_T_world_; }

 private:
  cameras::CameraModel camera_;
  int width_px_, height_px_;
  Eigen::Isometry3d camera_T_world_;
  Eigen::Matrix3d world_from_camera_;
  Eigen::Vector3d origin_mm_;
  std::vector<Eigen::Vector2d> table_;  // (width + 2) x (height + 2), one pixel beyond the image on each side
};

}  // namespace facenav::room
