#include "skin_patches.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "fit_report.h"

namespace facenav::registration {
namespace {

/// What varies faster than this (mesh facets, the matcher's window) is shared by neighbouring points.
constexpr double kGrain_mm2 = 28.0;
constexpr double kLeastNoise_mm = 0.04;

long long cubeOf(const Eigen::Vector3f& p_mm, double size_mm) {
  const auto cell = [&](double x) { return (long long)(std::floor(x / size_mm)) & 0xfffff; };
  return cell(p_mm.x()) | cell(p_mm.y()) << 20 | cell(p_mm.z()) << 40;
}

SkinPatch average(const std::vector<PointMatch>& matches, const std::vector<int>& members, double limit_mm,
                  const Eigen::Vector3d& pivot) {
  std::vector<double> residuals;
  for (const int m : members) residuals.push_back(matches[std::size_t(m)].residual_mm);
  const double middle = median(residuals);
  SkinPatch patch;
  double squares = 0;
  for (const int m : members) {
    const PointMatch& match = matches[std::size_t(m)];
    const double off = match.residual_mm - middle;
    if (std::abs(off) > limit_mm) continue;
    const Eigen::Vector3d at = match.at_mri_mm.cast<double>(), normal = match.normal_mri.cast<double>();
    Vector6d j;
    j << (at - pivot).cross(normal), normal;
    patch.jacobian += j;
    patch.at_mri_mm += at;
    patch.normal += normal;
    patch.residual_mm += match.residual_mm;
    squares += off * off;
    ++patch.points;
  }
  const double n = std::max(1, patch.points);
  patch.jacobian /= n, patch.at_mri_mm /= n, patch.residual_mm /= n;
  patch.normal.normalize();
  patch.noise_mm = std::sqrt(squares / n);
  return patch;
}

}  // namespace

std::vector<SkinPatch> gatherPatches(const std::vector<PointMatch>& matches, double size_mm, double limit_mm,
                                     const Eigen::Vector3d& pivot, std::vector<int>* index) {
  std::unordered_map<long long, int> numbers;
  std::vector<std::vector<int>> members;
  std::vector<int> beyond;
  if (index) index->assign(matches.size(), -1);
  for (std::size_t m = 0; m < matches.size(); ++m) {
    if (!matches[m].is_valid || std::abs(matches[m].residual_mm) > 4 * limit_mm) continue;
    const auto [entry, is_new] =
        numbers.try_emplace(cubeOf(matches[m].at_mri_mm, size_mm), int(members.size()));
    if (is_new) members.emplace_back(), beyond.push_back(0);
    if (std::abs(matches[m].residual_mm) <= limit_mm)
      members[std::size_t(entry->second)].push_back(int(m));
    else
      ++beyond[std::size_t(entry->second)];
    if (index) (*index)[m] = entry->second;
  }
  std::vector<int> number(members.size(), -1), counts;
  std::vector<SkinPatch> patches;
  for (std::size_t c = 0; c < members.size(); ++c) {
    if (members[c].size() < 5) continue;
    number[c] = int(patches.size());
    patches.push_back(average(matches, members[c], limit_mm, pivot));
    patches.back().covered = double(members[c].size()) / double(members[c].size() + std::size_t(beyond[c]));
    counts.push_back(int(members[c].size()));
  }
  if (index)
    for (int& i : *index) i = i >= 0 ? number[std::size_t(i)] : -1;
  if (patches.empty()) return patches;
  std::nth_element(counts.begin(), counts.begin() + std::ptrdiff_t(counts.size() / 2), counts.end());
  const double full = counts[counts.size() / 2];
  for (SkinPatch& patch : patches) {
    const double grains = std::max(1.0, std::min(1.5, patch.points / full) * size_mm * size_mm / kGrain_mm2);
    patch.noise_mm = std::hypot(patch.noise_mm / std::sqrt(grains), kLeastNoise_mm);
  }
  return patches;
}

}  // namespace facenav::registration
