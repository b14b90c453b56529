#pragma once
// PlaneWarp: affine map of the pixels of a small plane patch of skin from the reference frame to another
// pose, from pose and surface normal.

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <vector>

#include "facenav/cameras/stereo_rig.h"

namespace facenav::peers {

struct PlaneWarp {
  Eigen::Vector2d px = Eigen::Vector2d::Zero();  // the patch's centre in the current image
  Eigen::Matrix2d reference_from_now = Eigen::Matrix2d::Identity();  // maps pixel offsets
  bool is_visible = false;                                           // in front of the camera and facing it
};

/// The patch at `p_mm` with outward `normal` (both Camera at the reference), after the head's `motion`, seen
/// by the camera at `camera_T_left`.
PlaneWarp warpOfPlane(const cameras::CameraModel& camera, const Eigen::Isometry3d& camera_T_left,
                      const Eigen::Vector3d& p_mm, const Eigen::Vector3d& normal,
                      const Eigen::Isometry3d& motion);

/// (2 half + 1)^2 pixels round `centre_px` of `image`, stepping by the columns of `step`, 8-bit.
cv::Mat cutPatch(const cv::Mat& image, const Eigen::Vector2d& centre_px, const Eigen::Matrix2d& step,
                 int half);

/// Unit normal of the plane through the points, towards the camera.
Eigen::Vector3d facePlaneNormal(const std::vector<Eigen::Vector3d>& points_mm);

}  // namespace facenav::peers
