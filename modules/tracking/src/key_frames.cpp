#include "key_frames.h"

#include <Eigen/LU>
#include <algorithm>

#include "patch_looks.h"
#include "patch_placement.h"

namespace facenav::tracking {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kNewSide_rad = 11 * kDegree;        // from every other key frame
constexpr double kAlike_rad = 2 * kDegree;           // no change of key frame for less
constexpr double kGenerationCost_rad = 4 * kDegree;  // of a key frame made from a key frame
constexpr int kOldestGeneration = 3;
constexpr std::size_t kMost = 16, kPatchesAtOnce = 24;
constexpr double kLeastQuality = 0.8, kWorstScale = 3.0, kWorstSigma_mm = 0.25;  // worth learning from
constexpr int kLeastUsable = 60;
constexpr int kMargin_px = 16;

double angleBetween(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return rotationAngle(a.linear().transpose() * b.linear());
}

PatchPoints pointsOfPatch(const PatchLevel& level, std::size_t i) {
  PatchPoints points;
  const Patch& patch = level.patches[i];
  for (int k = 0; k < patch::kSamples; ++k) {
    const std::size_t at = i * patch::kSamples + k;
    points.points_mm.emplace_back(level.x[at], level.y[at], level.z[at]);
  }
  points.centre_mm = patch.centre_mm, points.normal = patch.normal;
  return points;
}

// The skin's directions that move by one pixel in the new key frame.
void turnTangents(const stereo::StereoRig& rig, const Eigen::Isometry3d& motion, Patch& patch) {
  Eigen::Matrix<double, 2, 3> d_p;
  stereo::project(rig.left, motion * patch.centre_mm, d_p);
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << patch.right_mm, patch.down_mm;
  const Eigen::Matrix2d now_from_old = d_p * motion.linear() * tangents;
  if (std::abs(now_from_old.determinant()) < 0.05) return;
  const Eigen::Matrix<double, 3, 2> turned = tangents * now_from_old.inverse();
  patch.right_mm = turned.col(0), patch.down_mm = turned.col(1);
}

void setLooks(PatchLevel& level, std::size_t i, int camera, const PatchLooks& looked) {
  level.patches[i].view[camera] = looked.view;
  if (!looked.view.is_usable) return;
  const auto at = std::ptrdiff_t(i * patch::kSamples);
  auto& looks = level.looks[camera];
  std::copy(looked.grey.begin(), looked.grey.end(), looks.grey.begin() + at);
  std::copy(looked.d_u.begin(), looked.d_u.end(), looks.d_u.begin() + at);
  std::copy(looked.d_v.begin(), looked.d_v.end(), looks.d_v.begin() + at);
}

}  // namespace

KeyFrames::KeyFrames(const PatchModel& model) {
  KeyFrame reference;
  reference.level = model.level[0];
  keys_.push_back(std::move(reference));
}

const KeyFrame& KeyFrames::nearest(const Eigen::Isometry3d& motion) {
  const auto cost = [&](std::size_t i) {
    return angleBetween(keys_[i].motion, motion) + kGenerationCost_rad * keys_[i].generation;
  };
  std::size_t best = chosen_;
  for (std::size_t i = 0; i < keys_.size(); ++i)
    if (cost(i) < cost(best)) best = i;
  if (cost(best) < cost(chosen_) - kAlike_rad) chosen_ = best;
  return keys_[chosen_];
}

bool KeyFrames::learn(const stereo::StereoRig& rig, const PatchModel& model, const stereo::StereoFrame& frame,
                      const PoseFit& fit, const Verdict& verdict) {
  if (unfinished_) {
    goOn(rig, model);
    return false;
  }
  if (keys_.size() >= kMost || verdict.quality < kLeastQuality || fit.scale > kWorstScale) return false;
  if (std::sqrt(verdict.covariance.bottomRightCorner<3, 3>().trace()) > kWorstSigma_mm) return false;
  if (keys_[chosen_].generation + 1 > kOldestGeneration) return false;
  for (const auto& key : keys_)
    if (angleBetween(key.motion, fit.motion) < kNewSide_rad) return false;
  begin(rig, model, frame, fit, verdict);
  return true;
}

void KeyFrames::begin(const stereo::StereoRig& rig, const PatchModel& model, const stereo::StereoFrame& frame,
                      const PoseFit& fit, const Verdict& verdict) {
  Unfinished fresh;
  fresh.key.motion = fit.motion;
  fresh.key.covariance = verdict.covariance;
  fresh.key.generation = keys_[chosen_].generation + 1;
  fresh.key.level = keys_.front().level;
  const auto boxes = boxesAt(rig, model, fit.motion, kMargin_px);
  for (int c = 0; c < 2; ++c) {
    const BlurredImage part = blurredPart(c == 0 ? frame.left : frame.right, boxes[c]);
    fresh.grey[c] = greyOf(part);
    fresh.origin[c] = part.origin;
  }
  for (const auto& sight : fit.sights) fresh.is_good.push_back({sight[0].isGood(), sight[1].isGood()});
  unfinished_ = std::move(fresh);
}

void KeyFrames::goOn(const stereo::StereoRig& rig, const PatchModel& model) {
  auto& level = unfinished_->key.level;
  const std::size_t end = std::min(unfinished_->next + kPatchesAtOnce, level.patches.size());
  for (std::size_t i = unfinished_->next; i < end; ++i) {
    const PatchPoints points = pointsOfPatch(level, i);
    for (int c = 0; c < 2; ++c) {
      const auto& camera = c == 0 ? rig.left : rig.right;
      const Eigen::Isometry3d camera_T_head =
          c == 0 ? unfinished_->key.motion : rig.right_T_left.isometry() * unfinished_->key.motion;
      PatchLooks looked;
      if (unfinished_->is_good[i][c] && !unfinished_->grey[c].empty())
        looked = look(camera, camera_T_head, unfinished_->grey[c], unfinished_->origin[c], points, 0,
                      model.noise_grey);
      if (looked.view.is_usable)
        addJacobian(camera, camera_T_head, points.centre_mm, model.centre_mm, 0, looked.view);
      unfinished_->usable += looked.view.is_usable;
      setLooks(level, i, c, looked);
    }
    turnTangents(rig, unfinished_->key.motion, level.patches[i]);
  }
  unfinished_->next = end;
  if (end < level.patches.size()) return;
  if (unfinished_->usable >= 2 * kLeastUsable) keys_.push_back(std::move(unfinished_->key));
  unfinished_.reset();
}

}  // namespace facenav::tracking
