#include "facenav/efield/local_sphere.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "facenav/core/error.h"

namespace facenav::efield {
namespace {

constexpr double kReach_mm = 80;  // relative error against three shells 16 %; with all points 24 %
constexpr double kSmallest_mm = 30, kLargest_mm = 130;
constexpr int kFewest = 100;  // points near the coil

/// |p|^2 = 2 c.p + (R^2 - |c|^2), relative to the points' mean.
LocalSphere fitted(const std::vector<Eigen::Vector3d>& points_mm) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& p : points_mm) mean += p / double(points_mm.size());
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const auto& p_mm : points_mm) {
    const Eigen::Vector3d p = p_mm - mean;
    const Eigen::Vector4d row(2 * p.x(), 2 * p.y(), 2 * p.z(), 1);
    normal += row * row.transpose();
    right += row * p.squaredNorm();
  }
  const Eigen::Vector4d solution = normal.ldlt().solve(right);
  LocalSphere sphere;
  sphere.centre_mm = solution.head<3>() + mean;
  sphere.radius_mm = std::sqrt(std::max(0.0, solution[3] + solution.head<3>().squaredNorm()));
  return sphere;
}

bool isHeadSized(const LocalSphere& sphere) {
  return sphere.centre_mm.allFinite() && sphere.radius_mm >= kSmallest_mm && sphere.radius_mm <= kLargest_mm;
}

}  // namespace

LocalSphere localSphere(const std::vector<Eigen::Vector3d>& surface_mm, const Eigen::Vector3d& coil_mm) {
  std::vector<Eigen::Vector3d> near;
  for (const auto& p : surface_mm)
    if ((p - coil_mm).norm() <= kReach_mm) near.push_back(p);
  if (near.size() >= std::size_t(kFewest)) {
    const auto sphere = fitted(near);
    if (isHeadSized(sphere)) return sphere;
  }
  if (surface_mm.size() >= 4) {
    auto sphere = fitted(surface_mm);
    sphere.is_local = false;
    if (isHeadSized(sphere)) return sphere;
  }
  throw Error("no sphere of a head's size fits the surface under the coil", {},
              "check the target's pose and the case's surfaces");
}

}  // namespace facenav::efield
