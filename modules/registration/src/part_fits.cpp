#include "part_fits.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace facenav::registration {
namespace {

/// A part: between these quantiles of the points, from the patient's left to right and from below to above.
struct Part {
  double left, right, below, above;
};
constexpr Part kParts[] = {{0, 1, 0, 1},   {0, 1, 0, 0.8}, {0, 1, 0, 0.6}, {0, 1, 0, 0.45},
                           {0, 1, 0.3, 1}, {0, 0.5, 0, 1}, {0.5, 1, 0, 1}, {0.15, 0.85, 0, 0.7}};

/// Misfit of skin and MRI changes the support of a right pose by about this share, so that poses which differ
/// by less cannot be told apart; what is left below `kLeastWeight` lies outside a 95 % bound.
constexpr double kSupportSpread = 0.04, kLeastWeight = 0.05;

float quantile(std::vector<float> values, double fraction) {
  const auto at = values.begin() + std::ptrdiff_t(fraction * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::vector<float> weightsOf(const Part& part, const std::vector<PointMatch>& matches) {
  std::vector<float> x, z, weights;
  for (const PointMatch& m : matches)
    if (m.is_valid) x.push_back(m.at_mri_mm.x()), z.push_back(m.at_mri_mm.z());
  if (x.empty()) return {};
  const float left = quantile(x, part.left), right = quantile(x, part.right), below = quantile(z, part.below),
              above = quantile(z, part.above);
  for (const PointMatch& m : matches)
    weights.push_back(m.at_mri_mm.x() >= left && m.at_mri_mm.x() <= right && m.at_mri_mm.z() >= below &&
                              m.at_mri_mm.z() <= above
                          ? 1.0f
                          : 0.0f);
  return weights;
}

}  // namespace

float closeness(const PointMatch& match) {
  if (!match.is_valid) return 0.0f;
  float sum = 0.0f;
  for (const float outside_mm : {0.4f, 0.8f, 1.6f}) {
    const float u = match.residual_mm / (match.residual_mm > 0 ? outside_mm : 1.5f * outside_mm);
    sum += std::max(match.residual_mm > 0 ? 0.0f : -0.5f, 1.0f - u * u);
  }
  return sum / 3.0f;
}

double support(const FieldFitter& fitter, const Eigen::Isometry3d& mri_T_camera) {
  double sum = 0;
  for (const PointMatch& m : fitter.match(mri_T_camera)) sum += double(closeness(m));
  return sum;
}

double pairedZ(const std::vector<PointMatch>& one, const std::vector<PointMatch>& other) {
  constexpr float kPatch_mm = 25.0f;
  std::unordered_map<int, std::pair<double, int>> patches;
  for (std::size_t p = 0; p < one.size(); ++p) {
    if (!one[p].is_valid && !other[p].is_valid) continue;
    const Eigen::Vector3i cell = (one[p].at_mri_mm / kPatch_mm).array().floor().cast<int>();
    auto& [sum, count] = patches[(cell.x() & 255) | (cell.y() & 255) << 8 | (cell.z() & 255) << 16];
    sum += double(closeness(one[p])) - double(closeness(other[p]));
    ++count;
  }
  double sum = 0, squares = 0, n = 0;
  for (const auto& entry : patches) {
    if (entry.second.second < 5) continue;
    const double mean = entry.second.first / entry.second.second;
    sum += mean, squares += mean * mean, n += 1;
  }
  if (n < 6) return 0;
  const double mean = sum / n, variance = std::max(1e-6, (squares - n * mean * mean) / (n - 1));
  return mean / std::sqrt(variance / n);
}

PartFit bestOfParts(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
                    const Eigen::Isometry3d& mri_T_camera) {
  struct Pose {
    Eigen::Isometry3d mri_T_camera;
    double support;
  };
  const FieldFitter all(scalp, face, points);
  const auto matches = all.match(mri_T_camera);
  std::vector<Pose> poses;
  for (const Part& part : kParts) {
    const std::vector<float> weights = weightsOf(part, matches);
    std::vector<int> members;
    for (std::size_t p = 0; p < weights.size(); ++p)
      if (weights[p] > 0) members.push_back(points[p]);
    const FieldFitter alone(scalp, face, members);
    Eigen::Isometry3d pose = mri_T_camera;
    for (const float reach_mm : {6.0f, 4.0f, 2.5f, 1.5f})
      pose = alone.fit(pose, {reach_mm, 0.67f * reach_mm, 4, true});
    for (const float reach_mm : {1.6f, 1.2f}) pose = all.fit(pose, {reach_mm, 0.67f * reach_mm, 4, true});
    poses.push_back({pose, support(all, pose)});
  }
  std::sort(poses.begin(), poses.end(), [](const Pose& a, const Pose& b) { return a.support > b.support; });
  PartFit fit{poses.front().mri_T_camera};
  std::vector<Eigen::Isometry3d> seen{fit.mri_T_camera};
  double total = 1;
  for (const Pose& pose : poses) {
    const bool is_new = std::all_of(seen.begin(), seen.end(), [&](const Eigen::Isometry3d& s) {
      return areDistinct(s, pose.mri_T_camera, scalp.middle_mm(), 0.005, 0.5);
    });
    const double weight = std::exp((pose.support / poses.front().support - 1.0) / kSupportSpread);
    if (!is_new || weight < kLeastWeight) continue;
    seen.push_back(pose.mri_T_camera);
    const Eigen::Isometry3d apart = pose.mri_T_camera * fit.mri_T_camera.inverse();
    Vector6d d;
    d << logRotation(apart.linear()), apart * scalp.middle_mm() - scalp.middle_mm();
    fit.doubt += weight * d * d.transpose();
    total += weight;
  }
  fit.doubt /= total;
  return fit;
}

}  // namespace facenav::registration
