#include <algorithm>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"

namespace facenav::cameras {
namespace {

using Vector3d = Eigen::Vector3d;

// The mid-point of the shortest line between both rays. When the rays do not meet in front (parallel, or
// diverging by noise), the point lies far along the left ray: its depth is then meaningless, but finite.
Vector3d midPoint(const StereoRig& rig, const Vector3d& left_ray, const Vector3d& right_ray) {
  const auto left_T_right = rig.right_T_left.inverse();
  const Vector3d origin = left_T_right.translation_mm(), right = left_T_right.rotation() * right_ray;
  const double a = left_ray.dot(left_ray), b = left_ray.dot(right), c = right.dot(right);
  const double determinant = a * c - b * b, farthest_mm = 1e6;
  if (determinant < 1e-14 * a * c) return left_ray * farthest_mm;
  const double along_left = (c * left_ray.dot(origin) - b * right.dot(origin)) / determinant;
  const double along_right = (b * left_ray.dot(origin) - a * right.dot(origin)) / determinant;
  if (along_left <= 0 || along_left > farthest_mm) return left_ray * farthest_mm;
  return 0.5 * (left_ray * along_left + origin + right * along_right);
}

}  // namespace

Point<Camera> triangulate(const StereoRig& rig, const Eigen::Vector2d& left_px,
                          const Eigen::Vector2d& right_px) {
  const Eigen::Isometry3d& right_T_left = rig.right_T_left.isometry();
  Vector3d p =
      midPoint(rig, undistort(rig.left, left_px).homogeneous(), undistort(rig.right, right_px).homogeneous());
  for (int iteration = 0; iteration < 8; ++iteration) {
    const Vector3d p_right = right_T_left * p;
    if (p.z() <= 0 || p_right.z() <= 0) break;
    Eigen::Matrix<double, 2, 3> left_jacobian, right_jacobian;
    const Eigen::Vector2d left_miss = left_px - project(rig.left, p, left_jacobian);
    const Eigen::Vector2d right_miss = right_px - project(rig.right, p_right, right_jacobian);
    right_jacobian = (right_jacobian * right_T_left.linear()).eval();
    const Eigen::Matrix3d normal =
        left_jacobian.transpose() * left_jacobian + right_jacobian.transpose() * right_jacobian;
    const Vector3d step = solveSymmetric(
        normal, Vector3d(left_jacobian.transpose() * left_miss + right_jacobian.transpose() * right_miss));
    if (!step.allFinite() || (p + step).z() <= 0) break;
    p += step;
    if (step.norm() < 1e-9 * p.norm()) break;
  }
  return Point<Camera>(p);
}

double epipolarError_px(const StereoRig& rig, const Eigen::Vector2d& left_px,
                        const Eigen::Vector2d& right_px) {
  const Vector3d left = undistort(rig.left, left_px).homogeneous(),
                 right = undistort(rig.right, right_px).homogeneous();
  const Eigen::Matrix3d essential = skew(rig.right_T_left.translation_mm()) * rig.right_T_left.rotation();
  const Vector3d line_right = essential * left, line_left = essential.transpose() * right;
  const double algebraic = std::abs(right.dot(line_right));
  const double focal_left = 0.5 * (rig.left.k(0, 0) + rig.left.k(1, 1));
  const double focal_right = 0.5 * (rig.right.k(0, 0) + rig.right.k(1, 1));
  return std::max(focal_right * algebraic / line_right.head<2>().norm(),
                  focal_left * algebraic / line_left.head<2>().norm());
}

}  // namespace facenav::cameras
