#include "sides.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace facenav::tracking {
namespace {

constexpr std::size_t kFewestInRegion = 3;
constexpr double kSigmaOfMad = 1.4826, kMedianNoise = 1.25;  // of a median, by that of a mean

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Signed, px of the right camera: how far the right pixel lies off the left one's epipolar line.
double offLine_px(const stereo::StereoRig& rig, const Eigen::Vector2d& left_px,
                  const Eigen::Vector2d& right_px) {
  const Eigen::Matrix3d essential = skew(rig.right_T_left.translation_mm()) * rig.right_T_left.rotation();
  const Eigen::Vector3d line = essential * stereo::undistort(rig.left, left_px).homogeneous();
  const double f_px = 0.5 * (rig.right.k(0, 0) + rig.right.k(1, 1));
  return f_px * line.dot(stereo::undistort(rig.right, right_px).homogeneous()) / line.head<2>().norm();
}

}  // namespace

EpipolarOffset epipolarOffset(const stereo::StereoRig& rig, const SkinPoints& points,
                              const std::vector<SkinMatch>& matches) {
  std::map<int, const SkinMatch*> in_left;
  for (const auto& match : matches)
    if (match.camera == 0) in_left[match.point] = &match;
  std::vector<double> all;
  std::map<int, std::vector<double>> by_region;
  for (const auto& match : matches) {
    if (match.camera != 1) continue;
    const auto left = in_left.find(match.point);
    if (left == in_left.end()) continue;
    all.push_back(offLine_px(rig, left->second->px, match.px));
    by_region[points[std::size_t(match.point)].region].push_back(all.back());
  }
  EpipolarOffset offset;
  offset.points = int(all.size());
  if (all.empty()) return offset;
  offset.median_px = median(all);
  std::vector<double> away;
  for (const double px : all) away.push_back(std::abs(px - offset.median_px));
  offset.spread_px = kSigmaOfMad * median(away);
  double sum = 0, noise = 0;
  int regions = 0;
  for (const auto& [region, px] : by_region) {
    if (px.size() < kFewestInRegion) continue;
    sum += std::pow(median(px), 2);
    noise += std::pow(kMedianNoise * offset.spread_px, 2) / double(px.size());
    ++regions;
  }
  if (regions > 0) offset.region_px = std::sqrt(std::max(0.0, (sum - noise) / regions));
  return offset;
}

}  // namespace facenav::tracking
