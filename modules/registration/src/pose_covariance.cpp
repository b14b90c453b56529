#include "pose_covariance.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace facenav::registration {
namespace {

struct Patch {
  Vector6d gradient = Vector6d::Zero();  // sum of weight * J
  double weight = 0.0, residual = 0.0;   // sums
};

/// From (w, v) applied in Mri at its origin to mri_T_camera, to the increment of camera_T_mri in Camera.
Matrix6d toCameraIncrement(const Eigen::Matrix3d& camera_R_mri) {
  Matrix6d carry = Matrix6d::Zero();
  carry.topLeftCorner<3, 3>() = -camera_R_mri;
  carry.bottomRightCorner<3, 3>() = -camera_R_mri;
  return carry;
}

}  // namespace

long long patchKey(const Eigen::Vector3d& p_mm, double size_mm) {
  const auto cell = [&](double x) { return (long long)(std::floor(x / size_mm)) & 0xfffff; };
  return cell(p_mm.x()) | cell(p_mm.y()) << 20 | cell(p_mm.z()) << 40;
}

Matrix6d poseCovariance(const std::vector<PointMatch>& matches, const std::vector<double>& weights,
                        const Eigen::Isometry3d& mri_T_camera, const UncertaintyModel& model) {
  Matrix6d information = Matrix6d::Zero();
  Vector6d offset = Vector6d::Zero();
  std::unordered_map<long long, Patch> patches;
  for (std::size_t p = 0; p < matches.size(); ++p) {
    if (weights[p] <= 0) continue;
    const PointMatch& m = matches[p];
    Vector6d j;
    j << m.at_mri_mm.cross(m.normal_mri), m.normal_mri;
    information += weights[p] * j * j.transpose();
    offset += weights[p] * j;
    Patch& patch = patches[patchKey(m.at_mri_mm, model.patch_mm)];
    patch.gradient += weights[p] * j;
    patch.weight += weights[p];
    patch.residual += weights[p] * m.residual_mm;
  }
  // Pooled variance of the patches' mean residuals, with the fit's six degrees of freedom given back.
  double squares = 0, total = 0, count = 0;
  for (const auto& entry : patches) {
    const Patch& patch = entry.second;
    squares += patch.residual * patch.residual / patch.weight;
    total += patch.weight;
    count += 1;
  }
  const double freedom = std::max(0.1, (count - 6) / std::max(count, 1.0));
  const double variance =
      std::max(squares / std::max(total, 1e-9) / freedom, model.least_patch_mm * model.least_patch_mm);
  Matrix6d spread = Matrix6d::Zero();
  for (const auto& entry : patches)
    spread += model.alike * variance * entry.second.gradient * entry.second.gradient.transpose();
  // Where patches are off by so much, the skin as a whole may be, too.
  const double common = model.common_offset_mm * model.common_offset_mm + variance;
  spread += common * offset * offset.transpose();
  const Matrix6d inverse = information.completeOrthogonalDecomposition().pseudoInverse();
  const Matrix6d carry = toCameraIncrement(mri_T_camera.linear().transpose());
  return carry * (inverse * spread * inverse) * carry.transpose();
}

}  // namespace facenav::registration
