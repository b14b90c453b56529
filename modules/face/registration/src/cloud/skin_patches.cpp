#include "skin_patches.h"

#include <algorithm>
#include <cmath>

#include "cube_numbers.h"
#include "facenav/core/robust_statistics.h"

namespace facenav::registration {
namespace {

/// Area within which residuals of points are correlated (mesh facets, the matcher's window).
constexpr double kGrain_mm2 = 28.0;
constexpr double kLeastNoise_mm = 0.04, kSlantNoise_mm = 0.1;

SkinPatch average(const std::vector<PointMatch>& matches, const std::vector<int>& members, double limit_mm,
                  const Eigen::Vector3d& pivot) {
  std::vector<double> residuals;
  for (const int m : members) residuals.push_back(double(matches[std::size_t(m)].residual_mm));
  const double middle = upperMedian(residuals);
  SkinPatch patch;
  double squares = 0;
  for (const int m : members) {
    const PointMatch& match = matches[std::size_t(m)];
    const double off = double(match.residual_mm) - middle;
    if (std::abs(off) > limit_mm) continue;
    const Eigen::Vector3d at = match.at_mri_mm.cast<double>(), normal = match.normal_mri.cast<double>();
    Vector6d j;
    j << (at - pivot).cross(normal), normal;
    patch.jacobian += j;
    patch.at_mri_mm += at;
    patch.normal += normal;
    patch.residual_mm += double(match.residual_mm);
    squares += off * off;
    ++patch.points;
  }
  const double n = std::max(1, patch.points);
  patch.jacobian /= n, patch.at_mri_mm /= n, patch.residual_mm /= n;
  patch.normal.normalize();
  patch.noise_mm = std::sqrt(squares / n);
  return patch;
}

/// Standard error of the patch's mean. Its points count as independent values of one grain each. On slanted
/// skin the matcher's window, which extends beyond the edge, adds to it.
double noiseOf(const SkinPatch& patch, double full, double size_mm, const Eigen::Vector3d& camera_mri_mm) {
  const double grains = std::max(1.0, std::min(1.5, patch.points / full) * size_mm * size_mm / kGrain_mm2);
  const double facing =
      std::clamp(patch.normal.dot((camera_mri_mm - patch.at_mri_mm).normalized()), 0.1, 1.0);
  const double aslant = kSlantNoise_mm * std::sqrt(1 - facing * facing) / facing;
  return std::hypot(patch.noise_mm / std::sqrt(grains), kLeastNoise_mm, aslant);
}

}  // namespace

std::vector<SkinPatch> gatherPatches(const std::vector<PointMatch>& matches, const PatchLimits& limits,
                                     const Eigen::Isometry3d& mri_T_camera, const Eigen::Vector3d& pivot) {
  const double limit_mm = std::max(limits.inside_mm, limits.outside_mm);
  CubeNumbers numbers(limits.size_mm);
  std::vector<std::vector<int>> members;
  std::vector<int> beyond;
  for (std::size_t m = 0; m < matches.size(); ++m) {
    const double residual = double(matches[m].residual_mm);
    if (!matches[m].is_valid || std::abs(residual) > 4 * limit_mm) continue;
    const auto patch = std::size_t(numbers.of(matches[m].at_mri_mm));
    if (patch == members.size()) members.emplace_back(), beyond.push_back(0);
    if (residual <= limits.outside_mm && residual >= -limits.inside_mm)
      members[patch].push_back(int(m));
    else
      ++beyond[patch];
  }
  std::vector<int> counts;
  std::vector<SkinPatch> patches;
  for (std::size_t c = 0; c < members.size(); ++c) {
    if (members[c].size() < 5) continue;
    patches.push_back(average(matches, members[c], limit_mm, pivot));
    patches.back().covered = double(members[c].size()) / double(members[c].size() + std::size_t(beyond[c]));
    counts.push_back(int(members[c].size()));
  }
  if (patches.empty()) return patches;
  const double full = upperMedian(std::move(counts));
  for (SkinPatch& patch : patches)
    patch.noise_mm = noiseOf(patch, full, limits.size_mm, mri_T_camera.translation());
  return patches;
}

}  // namespace facenav::registration
