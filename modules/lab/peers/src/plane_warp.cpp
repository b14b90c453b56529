#include "plane_warp.h"
#include "facenav/geometry/normal_equations.h"
#include "head/face_surface.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <opencv2/imgproc.hpp>

namespace facenav::peers {
namespace {

// d(pixel) / d(the two coordinates in the patch's plane).
Eigen::Matrix2d spread(const cameras::CameraModel& camera, const Eigen::Vector3d& p_mm,
                       const Eigen::Matrix<double, 3, 2>& axes) {
  Eigen::Matrix<double, 2, 3> jacobian;
  cameras::project(camera, p_mm, jacobian);
  return jacobian * axes;
}

}  // namespace

PlaneWarp warpOfPlane(const cameras::CameraModel& camera, const Eigen::Isometry3d& camera_T_left,
                      const Eigen::Vector3d& p_mm, const Eigen::Vector3d& normal,
                      const Eigen::Isometry3d& motion) {
  PlaneWarp warp;
  Eigen::Matrix<double, 3, 2> axes;
  axes.col(0) = normal.unitOrthogonal();
  axes.col(1) = normal.cross(axes.col(0));
  const Eigen::Isometry3d now = camera_T_left * motion;
  const Eigen::Vector3d p_reference_mm = camera_T_left * p_mm, p_now_mm = now * p_mm;
  if (p_now_mm.z() < 1.0 || p_reference_mm.z() < 1.0) return warp;
  if (-(now.linear() * normal).dot(p_now_mm.normalized()) < kGrazing_cos) return warp;
  const Eigen::Matrix2d reference = spread(camera, p_reference_mm, camera_T_left.linear() * axes);
  const Eigen::Matrix2d current = spread(camera, p_now_mm, now.linear() * axes);
  warp.px = cameras::project(camera, p_now_mm);
  warp.reference_from_now = reference * current.inverse();
  warp.is_visible = warp.reference_from_now.allFinite();
  return warp;
}

cv::Mat cutPatch(const cv::Mat& image, const Eigen::Vector2d& centre_px, const Eigen::Matrix2d& step,
                 int half) {
  const Eigen::Vector2d first = centre_px - step * Eigen::Vector2d(half, half);
  const cv::Matx23d source_from_patch(step(0, 0), step(0, 1), first.x(), step(1, 0), step(1, 1), first.y());
  cv::Mat patch;
  cv::warpAffine(image, patch, source_from_patch, {2 * half + 1, 2 * half + 1},
                 cv::INTER_CUBIC | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
  return patch;
}

Eigen::Vector3d facePlaneNormal(const std::vector<Eigen::Vector3d>& points_mm) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& p : points_mm) mean += p / double(points_mm.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& p : points_mm) scatter += (p - mean) * (p - mean).transpose();
  const Eigen::Vector3d normal = principalAxes(scatter).vectors.col(0);
  return normal.dot(mean) > 0 ? Eigen::Vector3d(-normal) : normal;
}

}  // namespace facenav::peers
