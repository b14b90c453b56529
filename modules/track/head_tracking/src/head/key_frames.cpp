#include "key_frames.h"

#include <Eigen/LU>
#include <algorithm>

#include "patch_appearance.h"
#include "patch_placement.h"

#include "facenav/geometry/rotation.h"

namespace facenav::head_tracking {
namespace {

constexpr double kNewSide_rad = 11 * kRadPerDeg;        // angle from every other key frame
constexpr double kAlike_rad = 2 * kRadPerDeg;           // a smaller gain does not change the key frame
constexpr double kGenerationCost_rad = 4 * kRadPerDeg;  // cost of a key frame made from another key frame
constexpr double kMomentGain_rad = 25 * kRadPerDeg;     // advantage of a key frame of the moment
constexpr std::size_t kMost = 16, kPatchesAtOnce = 44, kCoarseAtOnce = 6;
constexpr double kLeastQuality = 0.8, kLearnt_mm = 0.25;  // quality and largest sigma of a fit to learn from
constexpr int kKeptMargin_px = 48;  // around the patches' centres: half of the coarsest patch, and its blur

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

// Rescales the tangents to one pixel in the new key frame.
void turnTangents(const cameras::StereoRig& rig, const Eigen::Isometry3d& motion, int level, Patch& patch) {
  Eigen::Matrix<double, 2, 3> d_p;
  cameras::project(rig.left, motion * patch.centre_mm, d_p);
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << patch.right_mm, patch.down_mm;
  const Eigen::Matrix2d now_from_old = d_p * motion.linear() * tangents / double(1 << level);
  if (std::abs(now_from_old.determinant()) < 0.05) return;
  const Eigen::Matrix<double, 3, 2> turned = tangents * now_from_old.inverse();
  patch.right_mm = turned.col(0), patch.down_mm = turned.col(1);
}

void setAppearance(PatchLevel& level, std::size_t i, int camera, const PatchAppearance& appearance_now) {
  level.patches[i].view[camera] = appearance_now.view;
  if (!appearance_now.view.is_usable) return;
  const auto at = std::ptrdiff_t(i * patch::kSamples);
  auto& appearance = level.appearance[camera];
  std::copy(appearance_now.grey.begin(), appearance_now.grey.end(), appearance.grey.begin() + at);
  std::copy(appearance_now.d_u.begin(), appearance_now.d_u.end(), appearance.d_u.begin() + at);
  std::copy(appearance_now.d_v.begin(), appearance_now.d_v.end(), appearance.d_v.begin() + at);
}

}  // namespace

KeyFrames::KeyFrames(const PatchModel& model, int newest) : newest_(newest) {
  KeyFrame reference;
  reference.level = model.level;
  keys_.push_back(std::move(reference));
}

// Key frames of the moment come first, unless another shows the head from a much nearer side.
double KeyFrames::cost(std::size_t key, const Eigen::Isometry3d& motion) const {
  return (keys_[key].is_of_moment && prefers_moment_ ? -kMomentGain_rad : 0.0) +
         angleBetween(keys_[key].motion, motion) + kGenerationCost_rad * keys_[key].generation;
}

const KeyFrame& KeyFrames::nearest(const Eigen::Isometry3d& motion) {
  std::size_t best = chosen_;
  if (keys_[chosen_].is_of_moment && !prefers_moment_) chosen_ = best = 0;
  for (std::size_t i = 0; i < keys_.size(); ++i)
    if (cost(i, motion) < cost(best, motion)) best = i;
  if (cost(best, motion) < cost(chosen_, motion) - kAlike_rad) chosen_ = best;
  return keys_[chosen_];
}

const KeyFrame& KeyFrames::likeliest(const Eigen::Isometry3d& motion) const {
  std::size_t best = 0;
  for (std::size_t i = 1; i < keys_.size(); ++i)
    if (cost(i, motion) < cost(best, motion)) best = i;
  return keys_[best];
}

bool KeyFrames::isNewSide(const PoseFit& fit, const Verdict& verdict) const {
  if (keys_.size() >= kMost || verdict.quality < kLeastQuality || fit.scale > kAsExpected) return false;
  if (std::sqrt(verdict.covariance.bottomRightCorner<3, 3>().trace()) > kLearnt_mm) return false;
  return std::none_of(keys_.begin(), keys_.end(), [&](const KeyFrame& key) {
    return angleBetween(key.motion, fit.motion) < kNewSide_rad;
  });
}

// A new side has priority over unfinished coarse levels of the last one: a turning head would be past it.
bool KeyFrames::learn(const cameras::StereoRig& rig, const PatchModel& model,
                      const cameras::StereoFrame& frame, const PoseFit& fit, const Verdict& verdict,
                      const KeyMotion& moving) {
  const bool is_free = unfinished_.empty() || unfinished_.front().level > 0;
  if (is_free && isNewSide(fit, verdict)) {
    begin(rig, model, frame, fit, verdict, moving);
    return true;
  }
  if (!unfinished_.empty()) goOn(rig, model);
  return false;
}

KeyFrames::Unfinished KeyFrames::unfinishedAt(const cameras::StereoRig& rig, const PatchModel& model,
                                              const cameras::StereoFrame& frame,
                                              const Eigen::Isometry3d& motion) {
  Unfinished fresh;
  fresh.key.motion = motion;
  fresh.key.level = model.level;
  fresh.right_T_left = rig.right_T_left.isometry();
  const auto boxes = boxesAt(rig, model, motion, kKeptMargin_px);
  for (int c = 0; c < 2; ++c) {
    const cv::Mat& image = c == 0 ? frame.left : frame.right;
    cv::Rect box = boxes[c] & cv::Rect({}, image.size());
    const cv::Point shift(box.x % kCoarsestStep, box.y % kCoarsestStep);
    box = {box.tl() - shift, box.br()};
    fresh.image[c] = image(box).clone(), fresh.origin[c] = box.tl();
  }
  return fresh;
}

void KeyFrames::begin(const cameras::StereoRig& rig, const PatchModel& model,
                      const cameras::StereoFrame& frame, const PoseFit& fit, const Verdict& verdict,
                      const KeyMotion& moving) {
  Unfinished fresh = unfinishedAt(rig, model, frame, fit.motion);
  fresh.key.covariance = verdict.covariance;
  fresh.key.unseen_covariance = verdict.unseen_covariance;
  fresh.key.moving = moving;
  fresh.key.number = ++newest_;
  fresh.key.generation = keys_[chosen_].generation + 1;
  fresh.key.is_of_moment = keys_[chosen_].is_of_moment;
  fresh.key.level = keys_.front().level;
  for (const auto& measurement : fit.measurements)
    fresh.is_good.push_back({measurement[0].isGood(), measurement[1].isGood()});
  unfinished_.push_front(std::move(fresh));
}

std::optional<KeyFrame> KeyFrames::ofMoment(const cameras::StereoRig& rig, const PatchModel& model,
                                            const cameras::StereoFrame& frame,
                                            const Eigen::Isometry3d& motion, const Matrix6d& covariance,
                                            const Matrix6d& unseen_covariance) {
  KeyFrames keys(model);
  Unfinished fresh = unfinishedAt(rig, model, frame, motion);
  if (fresh.image[0].empty() || fresh.image[1].empty()) return std::nullopt;
  fresh.key.covariance = covariance, fresh.key.unseen_covariance = unseen_covariance;
  fresh.key.generation = 1;
  fresh.key.is_of_moment = true;
  fresh.is_good.assign(model.level[0].patches.size(), {true, true});
  keys.unfinished_.push_front(std::move(fresh));
  while (!keys.unfinished_.empty()) keys.goOn(rig, model);
  if (keys.keys_.size() < 2) return std::nullopt;
  return std::move(keys.keys_.back());
}

void KeyFrames::startMoment(KeyFrame key) {
  endMoment();
  key.number = ++newest_;
  keys_.push_back(std::move(key));
  chosen_ = keys_.size() - 1;
}

void KeyFrames::endMoment() {
  unfinished_.clear();  // indices of the key frames change
  keys_.erase(
      std::remove_if(keys_.begin(), keys_.end(), [](const KeyFrame& key) { return key.is_of_moment; }),
      keys_.end());
  chosen_ = 0;
}

const KeyFrame& KeyFrames::lasting(const Eigen::Isometry3d& motion) const {
  std::size_t best = 0;
  for (std::size_t i = 1; i < keys_.size(); ++i)
    if (!keys_[i].is_of_moment && cost(i, motion) < cost(best, motion)) best = i;
  return keys_[best];
}

bool KeyFrames::prepare() {
  Unfinished& fresh = unfinished_.front();
  for (int c = 0; c < 2; ++c) {
    if (fresh.image[c].empty()) continue;
    fresh.pyramid[c] = ImagePyramid(fresh.image[c], fresh.origin[c]);
    fresh.image[c].release();
    return true;
  }
  return false;
}

void KeyFrames::learnPatch(const cameras::StereoRig& rig, const PatchModel& model, std::size_t i) {
  Unfinished& fresh = unfinished_.front();
  PatchLevel& level = fresh.key.level[fresh.level];
  const PatchPoints points = pointsOfPatch(level, i);
  for (int c = 0; c < 2; ++c) {
    const auto& camera = c == 0 ? rig.left : rig.right;
    const Eigen::Isometry3d camera_T_head = c == 0 ? fresh.key.motion : fresh.right_T_left * fresh.key.motion;
    const BlurredImage& image = fresh.pyramid[c].level[fresh.level];
    PatchAppearance appearance_now;
    if ((fresh.level > 0 || fresh.is_good[i][c]) && !image.pixels.empty())
      appearance_now = appearanceOf(camera, camera_T_head, image, points, fresh.level,
                                    noiseBeforeBlur(model.noise_grey, fresh.level));
    if (appearance_now.view.is_usable) {
      addJacobian(camera, camera_T_head, points.centre_mm, model.centre_mm, fresh.level, appearance_now.view);
      fresh.usable += fresh.level == 0;
    }
    setAppearance(level, i, c, appearance_now);
  }
  turnTangents(rig, fresh.key.motion, fresh.level, level.patches[i]);
}

void KeyFrames::goOn(const cameras::StereoRig& rig, const PatchModel& model) {
  if (prepare()) return;
  Unfinished& fresh = unfinished_.front();
  const std::size_t all = fresh.key.level[fresh.level].patches.size();
  const std::size_t end = std::min(fresh.next + (fresh.level == 0 ? kPatchesAtOnce : kCoarseAtOnce), all);
  while (fresh.next < end) learnPatch(rig, model, fresh.next++);
  if (end < all) return;
  if (fresh.level == 0 && fresh.usable < 2 * int(kFewestPatches)) return unfinished_.pop_front();
  if (fresh.level == 0) {  // enough to track; the reference's coarser levels are used until they are learnt
    fresh.index = keys_.size();
    keys_.push_back(fresh.key);
  } else {
    keys_[fresh.index].level[fresh.level] = std::move(fresh.key.level[fresh.level]);
  }
  fresh.next = 0;
  if (++fresh.level == kLevels) unfinished_.pop_front();
}

}  // namespace facenav::head_tracking
