#include "facenav/stereo/cloud_fusion.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/robust_statistics.h"

namespace facenav::stereo {
namespace {

constexpr double kLeastFacing = 0.25;  // cosine; a steeper point is not moved along its plane
constexpr double kFarthest_mm = 2.0;   // largest move of a point along its plane to its pixel's ray
constexpr double kGate = 3.0;          // standard deviations from the median
constexpr double kPriorFrames = 2.0;  // weight of the predicted deviation as a prior of the spread, in frames

struct Distance {
  double mm, sigma_mm;
  int frames;
};

// Mean and deviation of the pixel from pairs of distance and deviation; `shared_mm` is part of each
// deviation.
Distance meanOf(const std::vector<std::pair<double, double>>& seen, double shared_mm) {
  if (seen.size() == 1) return {seen[0].first, seen[0].second, 1};
  std::vector<double> distances, sigmas;
  for (const auto& [distance_mm, sigma_mm] : seen)
    distances.push_back(distance_mm), sigmas.push_back(sigma_mm);
  const double middle_mm = upperMedian(distances), own_mm = upperMedian(sigmas);
  const double gate_mm =
      kGate * std::max(kSigmaPerMad * medianAbsoluteDeviation(distances, middle_mm), own_mm);
  double sum = 0, weights = 0;
  int near = 0;
  for (const auto& [distance_mm, sigma_mm] : seen) {
    if (std::abs(distance_mm - middle_mm) > gate_mm) continue;
    sum += distance_mm / (sigma_mm * sigma_mm), weights += 1 / (sigma_mm * sigma_mm), ++near;
  }
  const double mean_mm = sum / weights, shared_mm2 = shared_mm * shared_mm;
  double squares_mm2 = kPriorFrames * std::max(0.0, own_mm * own_mm - shared_mm2);
  for (const double d : distances)
    if (std::abs(d - middle_mm) <= gate_mm) squares_mm2 += (d - mean_mm) * (d - mean_mm);
  const double variance_mm2 = squares_mm2 / (kPriorFrames + near - 1);
  return {mean_mm, std::sqrt(variance_mm2 / near + shared_mm2), near};
}

}  // namespace

CloudFusion::CloudFusion(const cameras::StereoRig& rig, double shared_px)
    : rig_(rig), shared_px_(shared_px), cells_(std::size_t(rig.width_px) * std::size_t(rig.height_px)) {}

void CloudFusion::see(const Eigen::Vector3d& p_mm, const Eigen::Vector3d& normal, float sigma_mm) {
  if (!(p_mm.z() > 1)) return;
  const Eigen::Vector2d px = project(rig_.left, p_mm);
  const Eigen::Vector2d middle(std::round(px.x()), std::round(px.y()));
  if (!(middle.x() >= 0 && middle.y() >= 0 && middle.x() < rig_.width_px && middle.y() < rig_.height_px))
    return;
  Cell& cell = cells_[std::size_t(middle.y()) * std::size_t(rig_.width_px) + std::size_t(middle.x())];
  const float off_px = float((px - middle).norm());
  const bool is_again = cell.last_cloud == clouds_;
  if (is_again && cell.observations.back().off_px <= off_px) return;
  const Eigen::Vector3d ray = undistort(rig_.left, middle).homogeneous().normalized();
  const double facing = -normal.dot(ray), own_mm = p_mm.norm();
  const double along_mm = facing > kLeastFacing ? -normal.dot(p_mm) / facing : own_mm;
  const double distance_mm = std::abs(along_mm - own_mm) < kFarthest_mm ? along_mm : own_mm;
  const Observation observation{float(distance_mm), sigma_mm, off_px};
  if (is_again)
    cell.observations.back() = observation;
  else
    cell.observations.push_back(observation), cell.normals += normal.cast<float>();
  cell.last_cloud = clouds_;
}

void CloudFusion::add(const FaceCloud& cloud, const Eigen::Isometry3d& first_T_now) {
  FACENAV_EXPECT(
      cloud.cloud.normals.size() == cloud.cloud.size() && cloud.sigma_mm.size() == cloud.cloud.size(),
      "a cloud with normals and deviations is needed");
  for (std::size_t i = 0; i < cloud.cloud.size(); ++i)
    see(first_T_now * cloud.cloud.points_mm[i], first_T_now.linear() * cloud.cloud.normals[i],
        cloud.sigma_mm[i]);
  ++clouds_;
}

FusedCloud CloudFusion::fused() const {
  FusedCloud result;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Cell& cell = cells_[i];
    if (cell.observations.empty()) continue;
    std::vector<std::pair<double, double>> seen;
    for (const Observation& s : cell.observations) seen.emplace_back(s.distance_mm, s.sigma_mm);
    const double first_mm = seen.front().first;  // distance, which is nearly the depth
    const double shared_mm = shared_px_ * first_mm * first_mm / (rig_.left.k(0, 0) * rig_.baseline_mm());
    const Distance distance = meanOf(seen, shared_mm);
    const Eigen::Vector2d px(double(i % std::size_t(rig_.width_px)), double(i / std::size_t(rig_.width_px)));
    const Eigen::Vector3d ray = undistort(rig_.left, px).homogeneous().normalized();
    const Eigen::Vector3d normal = cell.normals.cast<double>();
    result.face.cloud.points_mm.push_back(distance.mm * ray);
    result.face.cloud.normals.push_back(normal.dot(ray) < 0 ? Eigen::Vector3d(normal.normalized()) : -ray);
    result.face.left_px.push_back(px.cast<float>());
    result.face.sigma_mm.push_back(float(distance.sigma_mm));
    result.frames.push_back(distance.frames);
  }
  return result;
}

}  // namespace facenav::stereo
