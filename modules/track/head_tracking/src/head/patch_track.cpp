#include "patch_track.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"
#include "patch_placement.h"
#include "pose_fit.h"
#include "track_verdict.h"

namespace facenav::head_tracking {
namespace {

constexpr double kReach_mm = 150.0;     // of a sudden motion of the head, besides walking
constexpr std::size_t kAskedParts = 8;  // parts of the patches; the identity check takes one per frame
constexpr int kLastingEvery = 20;  // tracked frames between two tries of the key frames from before a loss
constexpr int kMargin_px = 20;     // around the patches' centres: half a patch, and the remaining motion

std::vector<FaceFeature> featuresOf(const PoseFit& fit) {
  std::vector<FaceFeature> features;
  for (const auto& measurement : fit.measurements)
    if (measurement[0].is_visible && measurement[1].is_visible)
      features.push_back({measurement[0].px.cast<double>(), measurement[1].px.cast<double>(),
                          double(std::min(measurement[0].weight, measurement[1].weight))});
  return features;
}

cv::Rect boxOf(const PoseFit& fit, int camera) {
  std::vector<cv::Point> points;
  for (const auto& measurement : fit.measurements)
    if (measurement[camera].is_visible)
      points.emplace_back(int(measurement[camera].px.x()), int(measurement[camera].px.y()));
  return points.empty() ? cv::Rect() : cv::boundingRect(points);
}

}  // namespace

void PatchTrack::start(const cameras::StereoRig& rig, const HeadReference& reference,
                       const FaceRegion& region, const FaceSurface& surface) {
  const std::array<ImagePyramid, 2> key = {ImagePyramid(reference.frame.left),
                                           ImagePyramid(reference.frame.right)};
  model_ = learnPatches(rig, reference.frame, key, region, surface);
  model_.variance_factor = reference.surface.empty() ? 4.0 : 1.0;
  if (model_.level[0].patches.size() < 30)
    throw Error("no face with enough texture and depth is found in the reference frame", {},
                "look for blur, darkness or a covered face");
  camera_ = LateCamera(rig, model_.centre_mm);
  both_cameras_ = detailOfBothCameras(model_);
  keys_ = KeyFrames(model_);
  search_ = FaceSearch(rig, model_, key, FaceTemplate(rig, region, surface, model_.centre_mm));
  left_box_ = right_box_ = region.box();
  last_ = HeadMotion(model_.centre_mm);
  patch_weights_ = PatchWeights(model_.level[0].patches.size());
  words_ = LossWords(model_.centre_mm, model_.noise_grey, key[0], left_box_);
  lost_frames_ = 0, asked_part_ = 0, work_ = {};
}

void PatchTrack::forgetLearnt() {
  keys_ = KeyFrames(model_, keys_.newest());
  search_.forgetLearnt();
  patch_weights_.forget();
  last_.forget();
  lost_frames_ = 0;
}

void PatchTrack::beginFrame(int reserved) {
  // Not in two consecutive frames, since the search for a lost head needs work too.
  const bool has_just_left = work_.left_out > 0;
  work_ = {}, work_.left_out = has_just_left ? 0 : reserved;
}

std::optional<Eigen::Isometry3d> PatchTrack::expectedAt(Timestamp captured) {
  first_loss_.reset();
  if (last_.isRecent(captured)) return last_.predicted(captured);
  if (last_.isKnown()) last_.stopSteady();
  return std::nullopt;
}

std::optional<Eigen::Isometry3d> PatchTrack::lastPose() const {
  return last_.isKnown() ? std::optional(last_.pose()) : std::nullopt;
}

bool PatchTrack::fitsAsExpected() const { return fit_scale_ < kAsExpected; }

std::optional<PatchTrack::Followed> PatchTrack::follow(const Eigen::Isometry3d& predicted,
                                                       const cameras::StereoFrame& frame) {
  const KeyFrame& key = keys_.nearest(predicted);
  camera_.allowFor(key, predicted, last_.steady());
  const auto now = boxed(frame, predicted);
  const PoseFit fit = fitPose(camera_.now(), model_, key.level, now, predicted, 0, patch_weights_.weights());
  work_.comparisons += fit.comparisons;
  const Verdict verdict = verdictOf(key, fit);
  if (!verdict.isTracked() || isOtherPerson(key, now, fit)) {
    first_loss_ = {verdict.lost.value_or(LostReason::no_face), fit.motion};
    return std::nullopt;
  }
  if (const auto before = asBeforeTheLoss(frame, now, fit)) return Followed{*before, true};
  const Verdict whole = camera_.learn(key, fit, last_, frame.captured, verdict);
  learnSides(frame, fit, whole);  // `key` may be invalid after this
  return Followed{accepted(frame, fit, whole), false};
}

Verdict PatchTrack::verdictOf(const KeyFrame& key, const PoseFit& fit) const {
  Verdict verdict = judge(model_, fit, key.covariance, key.is_of_moment);
  verdict.unseen_covariance = key.unseen_covariance;
  verdict.key_number = key.number;
  return verdict;
}

// Level 0 of the parts of both images where the face is expected.
std::array<ImagePyramid, 2> PatchTrack::boxed(const cameras::StereoFrame& frame,
                                              const Eigen::Isometry3d& motion) const {
  const auto boxes = boxesAt(camera_.rig(), model_, motion, kMargin_px);
  std::array<ImagePyramid, 2> now;
  now[0].level[0] = blurredPart(frame.left, boxes[0]);
  now[1].level[0] = blurredPart(frame.right, boxes[1]);
  return now;
}

// True if another person took the patient's place between two frames. Each frame checks a part of the
// patches, and all of them if that part is not clearly the patient's.
bool PatchTrack::isOtherPerson(const KeyFrame& key, const std::array<ImagePyramid, 2>& now,
                               const PoseFit& fit) {
  asked_part_ = (asked_part_ + 1) % kAskedParts;
  return identityAt(key, now, fit, {kAskedParts, asked_part_}) != SkinIdentity::patient &&
         identityAt(key, now, fit) == SkinIdentity::other_person;
}

SkinIdentity PatchTrack::identityAt(const KeyFrame& key, const std::array<ImagePyramid, 2>& now,
                                    const PoseFit& fit, const PatchShare& share) const {
  return identityOfSkin(detailAgreement(camera_.now(), model_, key.level[0], now, fit, share), both_cameras_);
}

Tracked<HeadPose> PatchTrack::continueFrom(const Eigen::Isometry3d& camera_T_head,
                                           const std::optional<KeyFrame>& moment, bool is_fresh,
                                           const cameras::StereoFrame& frame) {
  const double since_s = std::max(0.0, frame.captured - last_.captured());
  if (last_.isKnown() && (camera_T_head * model_.centre_mm - last_.pose() * model_.centre_mm).norm() >
                             kReach_mm + kWalk_mm_s * since_s)
    return lost(LostReason::no_face, LossDetail::doubtful);  // faster than a person moves
  if (moment)
    keys_.startMoment(*moment);
  else
    keys_.endMoment();
  const std::array<ImagePyramid, 2> now = {ImagePyramid::coarse(frame.left),
                                           ImagePyramid::coarse(frame.right)};
  const auto there = attempt(frame, now, camera_T_head, {is_fresh, true});
  if (!there.verdict.isTracked()) {
    keys_.endMoment();
    return lost(*there.verdict.lost, detailOf(there, now, frame.captured));
  }
  return accepted(frame, there.fit, there.verdict);
}

// Tries the patches from before the loss while the head is tracked by a temporary key frame. If they fit too,
// they are preferred: they have no additional error to the reference.
std::optional<Tracked<HeadPose>> PatchTrack::asBeforeTheLoss(const cameras::StereoFrame& frame,
                                                             const std::array<ImagePyramid, 2>& now,
                                                             const PoseFit& by_moment) {
  if (!keys_.isOfMoment() || ++since_try_ % kLastingEvery != 0) return std::nullopt;
  const KeyFrame& key = keys_.lasting(by_moment.motion);
  const PoseFit fit =
      fitPose(camera_.now(), model_, key.level, now, by_moment.motion, 0, patch_weights_.weights());
  work_.comparisons += fit.comparisons;
  if (fit.scale > kAsExpected) return std::nullopt;
  const Verdict verdict = verdictOf(key, fit);
  if (!verdict.isTracked() || identityAt(key, now, fit) != SkinIdentity::patient) return std::nullopt;
  keys_.endMoment();
  return accepted(frame, fit, verdict);
}

Tracked<HeadPose> PatchTrack::search(const cameras::StereoFrame& frame,
                                     const std::optional<Eigen::Isometry3d>& expected, bool was_gone) {
  keys_.preferMoment((lost_frames_ % 2 == 0) != was_gone);
  auto result = searchInFrame(frame, expected);
  keys_.preferMoment(true);
  return result;
}

// Fits the result of the search to the end. It is shown only if the skin is the patient's.
Tracked<HeadPose> PatchTrack::searchInFrame(const cameras::StereoFrame& frame,
                                            const std::optional<Eigen::Isometry3d>& expected) {
  if (!work_.leavesTimeToSearch()) return lost(first_loss_->reason, wordOfFirst(frame.captured));
  const std::array<ImagePyramid, 2> now = {ImagePyramid::coarse(frame.left),
                                           ImagePyramid::coarse(frame.right)};
  const auto found = search_.seek(keys_, now, lastPose(), expected, lost_frames_ == 0, work_);
  if (found.is_swapped) return lost(LostReason::camera, LossDetail::swapped);
  if (!found.is_to_be_tried) {
    const bool is_there = found.is_deferred || !last_.isKnown();
    const auto& pose = is_there ? found.best.motion : last_.pose();
    const auto detail = words_.circumstance(pose, now[0], left_box_, last_, frame.captured);
    return lost(LostReason::no_face, detail.value_or(wordWithoutFit(found)));
  }
  const auto there = attempt(frame, now, found.best.motion, {false, false});
  if (there.verdict.isTracked()) return accepted(frame, there.fit, there.verdict);
  if (!there.fit.is_settled && there.fit.likeness > kLikely) search_.goOnFrom(there.fit.motion);
  return lost(*there.verdict.lost, detailOf(there, now, frame.captured));
}

PatchTrack::Attempt PatchTrack::attempt(const cameras::StereoFrame& frame,
                                        const std::array<ImagePyramid, 2>& now,
                                        const Eigen::Isometry3d& start, const Known& known) {
  const KeyFrame& key = keys_.nearest(start);
  camera_.allowFor(key, start, last_.steady());
  const int level = search_.roughLevel() - 1, first_level = known.is_rough ? kLevels - 1 : level;
  const PoseFit nearly = fitPose(camera_.now(), model_, key.level, now, start, first_level, {}, level);
  work_.comparisons += nearly.comparisons;
  const auto finest = boxed(frame, nearly.motion);
  PoseFit fit = fitPose(camera_.now(), model_, key.level, finest, nearly.motion, 0, patch_weights_.weights(),
                        0, work_.stepsLeft(model_));
  work_.comparisons += fit.comparisons;
  Verdict verdict = verdictOf(key, fit);
  if (!known.is_patient && verdict.isTracked() && identityAt(key, finest, fit) != SkinIdentity::patient)
    verdict.lost = LostReason::no_face;
  return {std::move(fit), std::move(verdict)};
}

// The functions from here to wordOfFirst() only find the loss detail; they do not change the track.
LossDetail PatchTrack::detailOf(const Attempt& there, const std::array<ImagePyramid, 2>& now,
                                Timestamp captured) const {
  return words_.circumstance(there.fit.motion, now[0], left_box_, last_, captured)
      .value_or(LossWords::of(*there.verdict.lost));
}

// Loss detail while a fit waits for the next frame: of this frame so far, or the previous one.
LossDetail PatchTrack::wordWithoutFit(const FaceSearch::Found& found) const {
  if (!found.is_deferred) return found.is_anything_alike ? LossDetail::doubtful : LossDetail::not_found;
  if (first_loss_) return LossWords::of(first_loss_->reason);
  return lost_frames_ > 0 ? detail_ : LossDetail::doubtful;
}

// Loss detail from the fit from the prediction.
LossDetail PatchTrack::wordOfFirst(Timestamp captured) const {
  return words_.isFar(first_loss_->motion, last_, captured) ? LossDetail::too_far
                                                            : LossWords::of(first_loss_->reason);
}

Tracked<HeadPose> PatchTrack::lost(LostReason reason, LossDetail detail) {
  detail_ = detail;
  ++lost_frames_;
  last_.stop();
  keys_.forgetUnfinished();
  return Lost{reason};
}

// Learns sides, but not in a frame with a search, which has used enough work.
void PatchTrack::learnSides(const cameras::StereoFrame& frame, const PoseFit& fit, const Verdict& verdict) {
  if (!work_.leavesTimeToFit()) return;
  const KeyMotion moving = camera_.motionOf(last_.steadyWith(fit.motion, frame.captured));
  if (keys_.learn(camera_.rigFor(fit.motion, moving), model_, frame, fit, verdict, moving))
    search_.add({ImagePyramid::coarse(frame.left), ImagePyramid::coarse(frame.right)}, fit.motion);
}

// Converts the observation from the head's frame to the right camera's. Motion of the head between two
// exposures looks like motion of the camera.
std::optional<health::RightPoseObservation> PatchTrack::rightCamera(const PoseFit& fit,
                                                                    const Verdict& verdict) const {
  if (!fit.sides) return std::nullopt;
  const Eigen::Isometry3d right_T_head = camera_.rig().right_T_left.isometry() * fit.motion;
  Matrix6d to_right = Matrix6d::Zero(), to_camera = Matrix6d::Zero();
  to_right.topLeftCorner<3, 3>() = to_right.bottomRightCorner<3, 3>() = right_T_head.linear();
  to_right.bottomLeftCorner<3, 3>() = skew(right_T_head * model_.centre_mm) * right_T_head.linear();
  to_camera.topLeftCorner<3, 3>() = to_camera.bottomRightCorner<3, 3>() = fit.motion.linear();
  const Vector6d late = camera_.sigma_s() * last_.steady();
  health::RightPoseObservation out;
  out.moved = to_right * fit.sides->zeta;
  out.covariance = to_right * (fit.sides->covariance + late * late.transpose()) * to_right.transpose();
  out.pose_by_moved = to_camera * fit.sides->xi_by_zeta * inverseOf(to_right);
  out.key = verdict.key_number, out.newest_key = keys_.newest();
  return out;
}

Tracked<HeadPose> PatchTrack::accepted(const cameras::StereoFrame& frame, const PoseFit& fit,
                                       const Verdict& verdict) {
  patch_weights_.learn(fit, last_.isKnown() ? frame.captured - last_.captured() : 0.0);
  detail_ = LossDetail::unknown;
  fit_scale_ = fit.scale;
  last_.add(fit.motion, frame.captured);
  lost_frames_ = 0;
  search_.end();
  HeadPose pose;
  pose.camera_T_head = RigidTransform<Camera, Head>::fromIsometry(fit.motion);
  pose.covariance = verdict.covariance + verdict.unseen_covariance;
  pose.face_centre = Point<Camera>(fit.motion * model_.centre_mm);
  pose.features = featuresOf(fit);
  pose.between_exposures_mm =
      last_.steady().tail<3>().norm() * (std::abs(camera_.late_s()) + camera_.sigma_s());
  pose.right_camera = rightCamera(fit, verdict);
  left_box_ = boxOf(fit, 0), right_box_ = boxOf(fit, 1);
  pose.face_left = left_box_;
  return {pose, verdict.quality};
}

}  // namespace facenav::head_tracking
