#include "passive_surface.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace facenav::head_tracking {
namespace {

constexpr double kNearer = 0.88, kFarther = 1.15;  // relative to the start depth
constexpr double kDisparityStep_px = 0.5;
constexpr int kNodeStep_px = 3;
constexpr float kStepPenalty = 0.025f,
                kJumpPenalty = 0.30f;     // per depth step between neighbours, and its maximum
constexpr double kSurfaceBlur_px = 14.0;  // radius of the quadrics fitted to the result

// 1 - NCC of every node with every depth: costs[(row * columns + column) * depths + depth].
struct CostVolume {
  int columns = 0, rows = 0, depths = 0;
  std::vector<float> inverse_depth, cost;
  float* at(std::vector<float>& volume, int x, int y) const {
    return &volume[(std::size_t(y) * columns + x) * depths];
  }
  const float* at(const std::vector<float>& volume, int x, int y) const {
    return &volume[(std::size_t(y) * columns + x) * depths];
  }
};

std::vector<float> inverseDepths(const cameras::StereoRig& rig, double start_depth_mm) {
  const double step = kDisparityStep_px / (rig.left.k(0, 0) * rig.baseline_mm());
  std::vector<float> list;
  for (double q = 1 / (kFarther * start_depth_mm); q <= 1 / (kNearer * start_depth_mm); q += step)
    list.push_back(float(q));
  return list;
}

// Right-image pixels of the left pixels of `box` if the scene were a plane at this depth. Computed at every
// eighth pixel and interpolated.
cv::Mat2f planeMap(const cameras::StereoRig& rig, const cv::Rect& box, double inverse_depth) {
  constexpr int kStep = 8;
  const cv::Size coarse(box.width / kStep + 2, box.height / kStep + 2);
  cv::Mat2f nodes(coarse);
  for (int y = 0; y < coarse.height; ++y)
    for (int x = 0; x < coarse.width; ++x) {
      const Eigen::Vector2d px(box.x + kStep * x, box.y + kStep * y);
      const Eigen::Vector3d p_mm = cameras::undistort(rig.left, px).homogeneous() / inverse_depth;
      const Eigen::Vector3d p_right_mm = rig.right_T_left.isometry() * p_mm;
      const Eigen::Vector2d right =
          p_right_mm.z() > 1 ? cameras::project(rig.right, p_right_mm) : Eigen::Vector2d(-100, -100);
      nodes(y, x) = {float(right.x()), float(right.y())};
    }
  cv::Mat2f fine;
  const cv::Matx23f sampling(1.f / kStep, 0, 0, 0, 1.f / kStep, 0);
  cv::warpAffine(nodes, fine, sampling, box.size(), cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                 cv::BORDER_REPLICATE);
  return fine;
}

cv::Mat1f boxMean(const cv::Mat1f& image, int side) {
  cv::Mat1f mean;
  cv::boxFilter(image, mean, CV_32F, {side, side}, {-1, -1}, true, cv::BORDER_REFLECT);
  return mean;
}

CostVolume makeCosts(const cameras::StereoRig& rig, const cameras::StereoFrame& frame, const cv::Rect& box,
                     double start_depth_mm) {
  CostVolume volume;
  volume.inverse_depth = inverseDepths(rig, start_depth_mm);
  volume.depths = int(volume.inverse_depth.size());
  volume.columns = (box.width - 1) / kNodeStep_px + 1, volume.rows = (box.height - 1) / kNodeStep_px + 1;
  volume.cost.assign(std::size_t(volume.columns) * volume.rows * volume.depths, 1.f);
  const int side = 2 * std::max(4, box.width / 34) + 1;
  cv::Mat1f left, right;
  frame.left(box).convertTo(left, CV_32F);
  frame.right.convertTo(right, CV_32F);
  const cv::Mat1f left_mean = boxMean(left, side),
                  left_variance = boxMean(left.mul(left), side) - left_mean.mul(left_mean);
  for (int d = 0; d < volume.depths; ++d) {
    cv::Mat1f warped;
    cv::remap(right, warped, planeMap(rig, box, volume.inverse_depth[d]), cv::Mat(), cv::INTER_LINEAR);
    const cv::Mat1f mean = boxMean(warped, side),
                    variance = boxMean(warped.mul(warped), side) - mean.mul(mean);
    const cv::Mat1f both = boxMean(left.mul(warped), side) - left_mean.mul(mean);
    for (int y = 0; y < volume.rows; ++y)
      for (int x = 0; x < volume.columns; ++x) {
        const int u = x * kNodeStep_px, v = y * kNodeStep_px;
        // Adds noise to the variances, so that flat skin has a shallow cost and follows its neighbours.
        const float scale =
            std::sqrt((std::max(0.f, left_variance(v, u)) + 4.f) * (std::max(0.f, variance(v, u)) + 4.f));
        volume.at(volume.cost, x, y)[d] = 1.f - std::clamp(both(v, u) / scale, 0.f, 1.f);
      }
  }
  return volume;
}

// from[d] plus the cheapest transition to a neighbour's depth, truncated linear in the difference (two
// passes).
void pass(const float* from, std::vector<float>& way, int depths) {
  float least = from[0];
  for (int d = 0; d < depths; ++d) way[d] = from[d], least = std::min(least, from[d]);
  for (int d = 1; d < depths; ++d) way[d] = std::min(way[d], way[d - 1] + kStepPenalty);
  for (int d = depths - 2; d >= 0; --d) way[d] = std::min(way[d], way[d + 1] + kStepPenalty);
  for (int d = 0; d < depths; ++d) way[d] = std::min(way[d], least + kJumpPenalty) - least;
}

std::vector<float> aggregate(const CostVolume& volume) {
  std::vector<float> sum(volume.cost.size(), 0.f), path(volume.cost.size()), way(volume.depths);
  const int directions[8][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};
  for (const auto& direction : directions) {
    const int dx = direction[0], dy = direction[1];
    const bool is_forward = dy > 0 || (dy == 0 && dx > 0);
    for (int k = 0; k < volume.rows * volume.columns; ++k) {
      const int index = is_forward ? k : volume.rows * volume.columns - 1 - k;
      const int x = index % volume.columns, y = index / volume.columns, px = x - dx, py = y - dy;
      const bool has_previous = px >= 0 && py >= 0 && px < volume.columns && py < volume.rows;
      if (has_previous) pass(volume.at(path, px, py), way, volume.depths);
      float* here = volume.at(path, x, y);
      const float* cost = volume.at(volume.cost, x, y);
      float* total = volume.at(sum, x, y);
      for (int d = 0; d < volume.depths; ++d) {
        here[d] = cost[d] + (has_previous ? way[d] : 0.f);
        total[d] += here[d];
      }
    }
  }
  return sum;
}

}  // namespace

FaceSurface passiveSurface(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                           const FaceRegion& region, double start_depth_mm) {
  const cv::Rect box = region.box() & cv::Rect(0, 0, rig.width_px, rig.height_px);
  std::vector<Eigen::Vector2f> left_px;
  std::vector<float> depth_mm;
  const CostVolume volume = makeCosts(rig, frame, box, start_depth_mm);
  const auto total = aggregate(volume);
  for (int y = 0; y < volume.rows; ++y)
    for (int x = 0; x < volume.columns; ++x) {
      const Eigen::Vector2d px(box.x + x * kNodeStep_px, box.y + y * kNodeStep_px);
      if (!region.contains(px)) continue;
      const float* cost = volume.at(total, x, y);
      const int best = int(std::min_element(cost, cost + volume.depths) - cost);
      if (best < 1 || best >= volume.depths - 1) continue;
      const float curvature = cost[best - 1] - 2 * cost[best] + cost[best + 1];
      const float offset = curvature > 0 ? 0.5f * (cost[best - 1] - cost[best + 1]) / curvature : 0.f;
      const float step = volume.inverse_depth[1] - volume.inverse_depth[0];
      left_px.push_back(px.cast<float>());
      depth_mm.push_back(1.f / (volume.inverse_depth[best] + offset * step));
    }
  return FaceSurface(left_px, depth_mm, {rig.width_px, rig.height_px}, kSurfaceBlur_px);
}

}  // namespace facenav::head_tracking
