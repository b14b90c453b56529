#pragma once
// CameraRays: the viewing ray of any image position of one camera, distortion included. The undistorted
// coordinates are tabulated at pixel centres (Newton on the distortion model, < 1e-9 px) and interpolated
// between them; over one pixel a lens bends by less than 1e-5 px.

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

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }
  const Eigen::Vector3d& origin_mm() const { return origin_mm_; }
  /// Direction in the world, z of the camera frame = 1 (so that distance along it is the depth). x, y within
  /// half a pixel of the image.
  Eigen::Vector3d direction(double x_px, double y_px) const;
  /// True where a world point falls into the image.
  bool shows(const Eigen::Vector3d& p_world_mm) const;
  /// The pixels in which a box (in its own frame, at `world_T_object`) can appear; nothing where it reaches
  /// behind or beside the camera too far to say.
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
