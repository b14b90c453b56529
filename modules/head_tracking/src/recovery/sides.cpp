#include "sides.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "facenav/core/robust_statistics.h"

namespace facenav::head_tracking {
namespace {

constexpr double kMedianNoise = 1.25;  // of a median, by that of a mean
constexpr int kFewest = 40;
// In step: 0.13 px at most (60 pairs of one real person, three rigs, five moments), 0.21 where both pictures
// are shifted sideways by 13 px. Two moments 1 mm apart: 0.23 to 0.50 px. All other moments: 2 px and more.
// Fitted on these.
constexpr double kBias_px = 0.20, kSigmas = 1.5;
constexpr double kSureAlone = 2.0;   // times the limit
constexpr double kOneFault_s = 1.0;  // between two answers that are judged together
constexpr double kClear_px = 1.0, kClearSigmas = 8.0, kClearSpread_px = 2.0;

// Signed, px of the right camera: how far the right pixel lies off the left one's epipolar line.
double offLine_px(const cameras::StereoRig& rig, const Eigen::Vector2d& left_px,
                  const Eigen::Vector2d& right_px) {
  const Eigen::Matrix3d essential = skew(rig.right_T_left.translation_mm()) * rig.right_T_left.rotation();
  const Eigen::Vector3d line = essential * cameras::undistort(rig.left, left_px).homogeneous();
  const double f_px = 0.5 * (rig.right.k(0, 0) + rig.right.k(1, 1));
  return f_px * line.dot(cameras::undistort(rig.right, right_px).homogeneous()) / line.head<2>().norm();
}

double sigmaOf(const EpipolarOffset& offset) {
  return kMedianNoise * offset.spread_px / std::sqrt(std::max(1.0, double(offset.points)));
}

double limitOf(const EpipolarOffset& offset, double allowed_px) {
  return kBias_px + allowed_px + kSigmas * sigmaOf(offset);
}

}  // namespace

bool EpipolarOffset::isOutOfStep(double allowed_px) const {
  return points >= kFewest && std::abs(median_px) > limitOf(*this, allowed_px);
}

bool EpipolarOffset::isClearlyOutOfStep() const {
  return points >= kFewest && spread_px < kClearSpread_px &&
         std::abs(median_px) > kClear_px + kClearSigmas * sigmaOf(*this);
}

StepVerdict StepWatch::judge(const EpipolarOffset& offset, double allowed_px, Timestamp captured) {
  const bool has_before = before_ && std::abs(captured - captured_) < kOneFault_s;
  const auto before = has_before ? before_ : std::nullopt;
  before_ = offset, captured_ = captured;
  EpipolarOffset both = offset;
  if (before) {
    both.median_px = 0.5 * (offset.median_px + before->median_px);
    both.points = offset.points + before->points;
  }
  const bool is_out = offset.isOutOfStep(allowed_px);
  if (is_out && std::abs(offset.median_px) > kSureAlone * limitOf(offset, allowed_px))
    return StepVerdict::out_of_step;
  if (before && both.isOutOfStep(allowed_px)) return StepVerdict::out_of_step;
  return is_out ? StepVerdict::unsure : StepVerdict::in_step;
}

EpipolarOffset epipolarOffset(const cameras::StereoRig& rig, const std::vector<SkinMatch>& matches) {
  std::map<int, const SkinMatch*> in_left;
  for (const auto& match : matches)
    if (match.camera == 0) in_left[match.point] = &match;
  std::vector<double> off_px;
  for (const auto& match : matches) {
    if (match.camera != 1) continue;
    const auto left = in_left.find(match.point);
    if (left != in_left.end()) off_px.push_back(offLine_px(rig, left->second->px, match.px));
  }
  EpipolarOffset offset;
  offset.points = int(off_px.size());
  offset.median_px = upperMedian(off_px);
  for (double& px : off_px) px = std::abs(px - offset.median_px);
  offset.spread_px = kSigmaPerMad * upperMedian(off_px);
  return offset;
}

}  // namespace facenav::head_tracking
