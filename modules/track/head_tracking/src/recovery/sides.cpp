#include "sides.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "facenav/core/robust_statistics.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/head_tracking/step_limits.h"
#include "facenav/health/face_offset.h"
#include "facenav/health/pair_diagnosis.h"

namespace facenav::head_tracking {
namespace {

constexpr double kUsualRms_px = 0.2;  // of a calibration that does not state it

// Signed distance of the right pixel from the left pixel's epipolar line, px of the right camera.
double offLine_px(const cameras::StereoRig& rig, const Eigen::Vector2d& left_px,
                  const Eigen::Vector2d& right_px) {
  const Eigen::Matrix3d essential = skew(rig.right_T_left.translation_mm()) * rig.right_T_left.rotation();
  const Eigen::Vector3d line = essential * cameras::undistort(rig.left, left_px).homogeneous();
  const double f_px = 0.5 * (rig.right.k(0, 0) + rig.right.k(1, 1));
  return f_px * line.dot(cameras::undistort(rig.right, right_px).homogeneous()) / line.head<2>().norm();
}

double harmful_px(const cameras::StereoRig& rig, double depth_mm) {
  return std::max(health::offsetOfDepthError_px(rig, settingsOf<StepLimits>().step_harm_mm, depth_mm),
                  rig.rms_px.value_or(kUsualRms_px));
}

double sigmaOf(const EpipolarOffset& offset) {
  return kMedianNoise * offset.spread_px / std::sqrt(std::max(1.0, double(offset.points)));
}

double limitOf(const EpipolarOffset& offset, double allowed_px) {
  const StepLimits& limits = settingsOf<StepLimits>();
  return offset.harmful_px + allowed_px + limits.step_sigmas * sigmaOf(offset);
}

}  // namespace

double EpipolarOffset::size_px() const {
  // Two matches of one point, each with its own error, scatter by twice its square across the line.
  const double of_matches = 2.0 * health::kMatchSigma_px * health::kMatchSigma_px;
  const double of_parts = std::max(0.0, spread_px * spread_px - of_matches);
  return std::sqrt(median_px * median_px + of_parts);
}

bool EpipolarOffset::isOutOfStep(double allowed_px) const {
  // Scatter about the lines alone is blur or compression. It counts only where the whole face is off them.
  const bool is_off = std::abs(median_px) > kSignificant * sigmaOf(*this);
  const double off_px = is_off ? size_px() : std::abs(median_px);
  return points >= settingsOf<StepLimits>().step_fewest && off_px > limitOf(*this, allowed_px);
}

bool EpipolarOffset::isClean() const {
  return points >= settingsOf<StepLimits>().step_fewest && size_px() < harmful_px;
}

bool EpipolarOffset::isClearlyOutOfStep() const {
  const StepLimits& limits = settingsOf<StepLimits>();
  return points >= limits.step_fewest && spread_px < limits.step_clear_spread_px &&
         std::abs(median_px) > limits.step_clear_px + limits.step_clear_sigmas * sigmaOf(*this);
}

double motionAcrossLines_mm(const cameras::StereoRig& rig, const Eigen::Vector3d& from_mm,
                            const Eigen::Vector3d& to_mm) {
  const Eigen::Vector3d right_eye_mm = rig.right_T_left.isometry().inverse().translation();
  return std::abs(right_eye_mm.cross(to_mm).normalized().dot(to_mm - from_mm));
}

StepVerdict StepWatch::judge(const EpipolarOffset& offset, double allowed_px, Timestamp captured) {
  const StepLimits& limits = settingsOf<StepLimits>();
  const bool has_before = before_ && std::abs(captured - captured_) < limits.step_one_fault_s;
  const auto before = has_before ? before_ : std::nullopt;
  before_ = offset, captured_ = captured;
  EpipolarOffset both = offset;
  if (before) {
    both.median_px = 0.5 * (offset.median_px + before->median_px);
    both.points = offset.points + before->points;
  }
  const bool is_out = offset.isOutOfStep(allowed_px),
             is_sure = is_out && offset.size_px() > limits.step_sure_alone * limitOf(offset, allowed_px);
  if (is_sure || (before && both.isOutOfStep(allowed_px))) {
    out_ = captured;
    return StepVerdict::out_of_step;
  }
  // The offset of a head that sways passes through zero where it turns back.
  const bool was_out = out_ && std::abs(captured - *out_) < limits.step_one_fault_s;
  return is_out || was_out ? StepVerdict::unsure : StepVerdict::in_step;
}

EpipolarOffset epipolarOffset(const cameras::StereoRig& rig, const std::vector<SkinMatch>& matches) {
  std::map<int, const SkinMatch*> in_left;
  for (const auto& match : matches)
    if (match.camera == 0) in_left[match.point] = &match;
  std::vector<double> off_px, depth_mm;
  for (const auto& match : matches) {
    if (match.camera != 1) continue;
    const auto left = in_left.find(match.point);
    if (left == in_left.end()) continue;
    off_px.push_back(offLine_px(rig, left->second->px, match.px));
    depth_mm.push_back(cameras::triangulate(rig, left->second->px, match.px).mm.z());
  }
  EpipolarOffset offset;
  offset.points = int(off_px.size());
  if (off_px.empty()) return offset;
  offset.median_px = upperMedian(off_px);
  offset.harmful_px = harmful_px(rig, std::max(1.0, upperMedian(depth_mm)));
  for (double& px : off_px) px = std::abs(px - offset.median_px);
  offset.spread_px = kSigmaPerMad * upperMedian(off_px);
  return offset;
}

}  // namespace facenav::head_tracking
