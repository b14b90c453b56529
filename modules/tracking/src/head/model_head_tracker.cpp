// "model": the default head tracker. Hundreds of skin patches, learnt from the reference frame and the dense
// cloud, fitted jointly in both images (pose_fit.h) from a constant-velocity prediction, always against the
// reference or a key frame made from it (key_frames.h), so nothing drifts. What is shown as tracked has
// passed the tests of track_verdict.h. Face detection runs at start only: a cascade takes tens of
// milliseconds, while the face's own pictures (coarse_search.h) find it again within a few frames of a few
// milliseconds each.

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "face/stereo_face.h"
#include "face_search.h"
#include "facenav/tracking/head_tracker.h"
#include "fine_detail.h"
#include "frame_guard.h"
#include "key_frames.h"
#include "offset_filter.h"
#include "patch_model.h"
#include "patch_placement.h"
#include "pose_fit.h"
#include "recovery/lost_face.h"
#include "skin_detail.h"
#include "track_verdict.h"

namespace facenav::tracking {
namespace {

constexpr double kLongestGap_s = 0.3;   // beyond it a prediction is worth nothing
constexpr double kSteady_s = 0.03;      // over which the velocity between two exposures is taken
constexpr double kTrustMemory_s = 0.7;  // over which a patch shows whether it moves by itself
constexpr double kWalk_mm_s = 1500.0, kNearlyFar = 1.25;
constexpr double kReach_mm = 150.0;           // of a sudden motion of the head, besides
constexpr double kFar = 1.6, kBlurred = 0.6;  // by the reference's distance, by its fine detail
constexpr double kGettingThere = 0.8;    // likeness of a fit that had not settled: the next frame goes on
constexpr int kLearnBelow_looks = 3400;  // at patches, in a frame
constexpr std::size_t kAskedParts = 8;   // of the patches, one a tracked frame: whose skin it is
constexpr int kLastingEvery = 20;        // tracked frames, between tries of the key frames from before a loss
constexpr double kSamePlace_mm = 0.4, kSameTurn_rad = 0.25 * M_PI / 180;  // of a try that is believed
constexpr double kAsExpected = 2.0;       // or where its errors are no larger, by those expected
constexpr double kCortexDepth_mm = 80.0;  // from the face to what must not move unseen
constexpr double kConfirmEvery_s = 1.5;   // while tracked
constexpr double kResting_mm_s = 20.0;    // of the cortex: 0.3 mm between exposures half a frame apart
constexpr int kMargin_px = 20;  // about the patches' centres: half a patch, and the motion left to find

class ModelHeadTracker : public HeadTracker {
 public:
  explicit ModelHeadTracker(std::shared_ptr<const FaceDetector> detector)
      : detector_(detector ? std::move(detector) : makeFaceDetector()) {}

  void setPace(Pace pace) override { pace_ = pace; }

  void start(const stereo::StereoRig& rig, const HeadReference& reference) override {
    lost_face_.reset();
    const auto face = findStereoFace(*detector_, rig, reference.frame);
    if (!face && reference.surface.empty())
      throw Error("no face is found in both images of the reference frame", {},
                  "let the face look towards the cameras, lit evenly");
    const cv::Size size = reference.frame.left.size();
    const FaceRegion region =
        face ? FaceRegion(face->left, size) : FaceRegion(reference.surface_left_px, size);
    const FaceSurface surface = measureSurface(rig, reference, region, face ? depthOf(rig, *face) : 0.0);
    const std::array<ImagePyramid, 2> key = {ImagePyramid(reference.frame.left),
                                             ImagePyramid(reference.frame.right)};
    model_ = learnPatches(rig, reference.frame, key, region, surface);
    model_.shape_doubt = reference.surface.empty() ? 4.0 : 1.0;
    if (model_.level[0].patches.size() < 30)
      throw Error("no face with enough texture and depth is found in the reference frame", {},
                  "look for blur, darkness or a covered face");
    rig_ = rig_now_ = rig;
    offset_.reset();
    both_cameras_ = detailOfBothCameras(model_);
    keys_ = KeyFrames(model_);
    search_ = FaceSearch(rig, model_, key, FaceTemplate(rig, region, surface, model_.centre_mm));
    left_box_ = right_box_ = face ? face->left.face : region.box();
    last_.reset();
    wander_.assign(model_.level[0].patches.size(), 0.0);
    lost_frames_ = 0, asked_part_ = 0, left_out_ = 0, work_ = {};
    confirmation_ = Confirmation::wanted, was_gone_ = true, other_seen_.reset();
    confirmed_ = reference.frame.captured;
    detail_at_start_ = fineDetail(key[0], left_box_, model_.noise_grey).value_or(0.0);
    guard_.start(reference.frame);
    lost_face_ = std::make_unique<LostFace>(
        std::make_shared<FaceRecovery>(rig, reference.frame, region, surface, face, detector_),
        LostFace::Learnt{&rig_, &model_, &both_cameras_}, pace_);
  }

  Tracked<HeadPose> track(const stereo::StereoFrame& frame) override {
    const auto fault =
        guard_.check(frame, last_ ? last_->velocity.tail<3>().norm() : 0.0, left_box_, right_box_);
    const bool has_just_left = work_.left_out > 0;  // not twice running: a lost head has its turn, too
    work_ = {}, work_.left_out = has_just_left ? 0 : left_out_;
    beside_ms_ = 0.0;
    if (fault) return refused(*fault);
    first_loss_.reset();
    const double dt_s = last_ ? frame.captured - last_->captured : 0.0;
    const bool is_recent = last_ && dt_s >= 0 && dt_s < kLongestGap_s;
    if (last_ && !is_recent) last_->steady.setZero();
    if (is_recent && confirmation_ == Confirmation::asked)
      if (const auto found = lost_face_->take(frame.captured)) {
        confirmation_ = Confirmation::none;
        if (found->is_other) return notThePatient();
        if (found->is_out_of_step) return outOfStep();
        if (found->moment && was_gone_) return continueFrom(*found, frame);
      }
    if (is_recent && lost_frames_ == 0) {
      const Eigen::Isometry3d predicted = predict(dt_s);
      const KeyFrame& key = keys_.nearest(predicted);
      allowFor(key, predicted);
      const auto now = boxed(frame, predicted);
      const PoseFit fit = fitPose(rig_now_, model_, key.level, now, predicted, 0, trust());
      work_.looks += fit.looks;
      const Verdict verdict = judge(model_, fit, key.covariance, key.is_of_moment);
      if (verdict.isTracked() && !isAnothers(key, now, fit)) {
        if (const auto before = asBeforeTheLoss(frame, now, fit)) return *before;
        const Verdict whole = withOffset(frame.captured, key, fit, verdict);
        learnSides(frame, fit, whole);  // ends the life of `key`
        auto pose = accepted(frame, fit, whole);
        confirmIfSteady(frame);
        return pose;
      }
      first_loss_ = {verdict.lost.value_or(LostReason::no_face), fit.motion};
    }
    return recover(frame, is_recent ? std::optional(predict(dt_s)) : std::nullopt);
  }

  LossDetail lossDetail() const override { return detail_; }

  ExposureOffset exposureOffset() const override { return {offset_.late_s(), offset_.sigma_s()}; }

  FrameWork work() const override { return work_; }

  double beside_ms() const override { return beside_ms_; }

  void leave(const FrameWork& work) override { left_out_ = work.looks; }

  void forgetLearnt() override {
    if (lost_face_) lost_face_->forget();
    keys_ = KeyFrames(model_);
    search_.forgetLearnt();
    wander_.assign(model_.level[0].patches.size(), 0.0);
    last_.reset();
    lost_frames_ = 0;
  }

 private:
  struct FirstLoss {
    LostReason reason;
    Eigen::Isometry3d motion;
  };
  struct Last {
    Eigen::Isometry3d motion;
    Vector6d velocity;  // per s, Head, about the model's centre
    Vector6d steady;    // the same over some frames
    Timestamp captured;
  };

  double depthOf(const stereo::StereoRig& rig, const StereoFace& face) const {
    std::vector<double> depths_mm;
    for (const auto& p_mm : face.points_mm) depths_mm.push_back(p_mm.z());
    if (depths_mm.empty()) {
      const auto centre = [](const cv::Rect& r) {
        return Eigen::Vector2d(r.x + 0.5 * r.width, r.y + 0.5 * r.height);
      };
      return stereo::triangulate(rig, centre(face.left.face), centre(face.right.face)).mm.z();
    }
    std::nth_element(depths_mm.begin(), depths_mm.begin() + depths_mm.size() / 2, depths_mm.end());
    return depths_mm[depths_mm.size() / 2];
  }

  Eigen::Isometry3d predict(double dt_s) const {
    return last_->motion * Eigen::Translation3d(model_.centre_mm) * expRigid(last_->velocity * dt_s) *
           Eigen::Translation3d(-model_.centre_mm);
  }

  // The right camera sees the head where it is when that camera exposes: as if the camera stood elsewhere.
  RigidTransform<RightCamera, Camera> rightThatSees(const Eigen::Isometry3d& motion,
                                                    const Vector6d& later) const {
    const Eigen::Isometry3d moved = motion * Eigen::Translation3d(model_.centre_mm) * expRigid(later) *
                                    Eigen::Translation3d(-model_.centre_mm) * motion.inverse();
    return RigidTransform<RightCamera, Camera>::fromIsometry(rig_.right_T_left.isometry() * moved);
  }

  // Beyond what it did when the key frame's pictures were taken.
  void allowFor(const KeyFrame& key, const Eigen::Isometry3d& motion) {
    const Vector6d velocity = last_ ? last_->steady : Vector6d(Vector6d::Zero());
    allowed_ = offset_.late_s() * (velocity - key.moving.velocity);
    rig_now_.right_T_left = rightThatSees(motion, allowed_ + key.moving.allowed);
  }

  Vector6d velocityNow(Timestamp captured, const PoseFit& fit) const {
    const double since_s = captured - last_->captured;
    return since_s < 1e-4 ? last_->steady : steady(velocityTo(fit, since_s), since_s);
  }

  // Learns from the frame when the right camera exposes; what is left uncertain counts in the covariance.
  Verdict withOffset(Timestamp captured, const KeyFrame& key, const PoseFit& fit, Verdict verdict) {
    const double since_s = captured - last_->captured;
    if (since_s < 1e-4) return verdict;
    offset_.add(key.level[0], fit, velocityNow(captured, fit) - key.moving.velocity, allowed_, since_s);
    Matrix6d rotate = Matrix6d::Zero();  // from Head's axes to Camera's
    rotate.topLeftCorner<3, 3>() = rotate.bottomRightCorner<3, 3>() = fit.motion.linear();
    verdict.covariance += rotate * offset_.poseCovariance() * rotate.transpose();
    return verdict;
  }

  // Level 0 of the parts of both images where the face is expected.
  std::array<ImagePyramid, 2> boxed(const stereo::StereoFrame& frame, const Eigen::Isometry3d& motion) const {
    const auto boxes = boxesAt(rig_, model_, motion, kMargin_px);
    std::array<ImagePyramid, 2> now;
    now[0].level[0] = blurredPart(frame.left, boxes[0]);
    now[1].level[0] = blurredPart(frame.right, boxes[1]);
    return now;
  }

  std::vector<float> trust() const {
    std::vector<float> factors;
    for (double wander : wander_) factors.push_back(float(1.0 / (1.0 + wander / 4.0)));
    return factors;
  }

  // Somebody else, put in the patient's place between two frames. A part of the patches is asked in each, all
  // of them where that part is in doubt.
  bool isAnothers(const KeyFrame& key, const std::array<ImagePyramid, 2>& now, const PoseFit& fit) {
    asked_part_ = (asked_part_ + 1) % kAskedParts;
    return whose(key, now, fit, {kAskedParts, asked_part_}) != Whose::patients &&
           whose(key, now, fit) == Whose::anothers;
  }

  Whose whose(const KeyFrame& key, const std::array<ImagePyramid, 2>& now, const PoseFit& fit,
              const PatchShare& share = {}) const {
    return whoseSkin(detailAgreement(rig_now_, model_, key.level[0], now, fit, share), both_cameras_);
  }

  // The prediction failed. An answer about an earlier frame comes first, then the search within the frame;
  // what it does not find is asked for beside the frames.
  Tracked<HeadPose> recover(const stereo::StereoFrame& frame,
                            const std::optional<Eigen::Isometry3d>& expected) {
    if (const auto found = lost_face_->take(frame.captured)) {
      if (found->is_other) other_seen_ = found->captured;
      if (found->is_out_of_step) return outOfStep();
      if (found->is_patient) return continueFrom(*found, frame);
    }
    const bool was_gone = last_ && !expected;
    keys_.preferMoment((lost_frames_ % 2 == 0) != was_gone);
    auto result = searchInFrame(frame, expected);
    keys_.preferMoment(true);
    if (result && !was_gone) return result;
    if (result && pace_ != Pace::patient) {
      confirmation_ = Confirmation::wanted, was_gone_ = true;
      return result;
    }
    lost_face_->ask(frame, last_ ? std::optional(last_->motion) : std::nullopt);
    beside_ms_ = lost_face_->takeBeside_ms();
    if (pace_ == Pace::patient)
      if (const auto found = lost_face_->take(frame.captured)) {
        if (found->is_other) other_seen_ = found->captured;
        if (result && found->is_other) return notThePatient();
        if (found->is_out_of_step) return outOfStep();
        if (found->moment || (!result && found->is_patient)) return continueFrom(*found, frame);
      }
    if (!result && detail_ == LossDetail::doubtful && other_seen_ &&
        std::abs(frame.captured - *other_seen_) < kLongestGap_s)
      detail_ = LossDetail::other_face;
    return result;
  }

  Tracked<HeadPose> notThePatient() { return lost(LostReason::no_face, LossDetail::other_face); }

  Tracked<HeadPose> outOfStep() { return lost(LostReason::camera, LossDetail::out_of_step); }

  // A face that was gone for a while may have come back with another expression: that its patches fit is not
  // enough. And now and then: are the pictures still of one moment, and the face the patient's? Asked while
  // the head rests, so that cameras that expose one after the other do no harm.
  void confirmIfSteady(const stereo::StereoFrame& frame) {
    const bool is_due = std::abs(frame.captured - confirmed_) > kConfirmEvery_s;
    if (confirmation_ == Confirmation::none && is_due)
      confirmation_ = Confirmation::wanted, was_gone_ = false;
    if (confirmation_ != Confirmation::wanted || keys_.isOfMoment()) return;
    const double speed_mm_s =
        last_->steady.tail<3>().norm() + kCortexDepth_mm * last_->steady.head<3>().norm();
    if (speed_mm_s > kResting_mm_s) return;
    lost_face_->ask(frame, last_->motion);
    beside_ms_ = lost_face_->takeBeside_ms();
    confirmation_ = Confirmation::asked, confirmed_ = frame.captured;
  }

  // From what was found beside the frames, some frames ago.
  Tracked<HeadPose> continueFrom(const LostFace::Found& found, const stereo::StereoFrame& frame) {
    if (last_ && (found.camera_T_head * model_.centre_mm - last_->motion * model_.centre_mm).norm() >
                     kReach_mm + kWalk_mm_s * std::max(0.0, frame.captured - last_->captured))
      return lost(LostReason::no_face, LossDetail::doubtful);  // nobody moves so fast
    if (found.moment)
      keys_.startMoment(*found.moment);
    else
      keys_.endMoment();
    const std::array<ImagePyramid, 2> now = {ImagePyramid::coarse(frame.left),
                                             ImagePyramid::coarse(frame.right)};
    const auto there = attempt(frame, now, found.camera_T_head, true);
    if (!there.verdict.isTracked()) {
      keys_.endMoment();
      return lost(*there.verdict.lost, detailOf(there, now, frame.captured));
    }
    lost_face_->remember(found);
    return accepted(frame, there.fit, there.verdict);
  }

  // The head is tracked by what it looked like when it was found anew. Where the patches learnt before the
  // loss fit again, too, they are the better ones: nothing lies between them and the reference.
  std::optional<Tracked<HeadPose>> asBeforeTheLoss(const stereo::StereoFrame& frame,
                                                   const std::array<ImagePyramid, 2>& now,
                                                   const PoseFit& by_moment) {
    if (!keys_.isOfMoment() || ++since_try_ % kLastingEvery != 0) return std::nullopt;
    const KeyFrame& key = keys_.lasting(by_moment.motion);
    const PoseFit fit = fitPose(rig_now_, model_, key.level, now, by_moment.motion, 0, trust());
    work_.looks += fit.looks;
    const Eigen::Isometry3d off = by_moment.motion.inverse() * fit.motion;
    const bool is_same = (off * model_.centre_mm - model_.centre_mm).norm() < kSamePlace_mm &&
                         rotationAngle(off.linear()) < kSameTurn_rad;
    if (!is_same && fit.scale > kAsExpected) return std::nullopt;
    const Verdict verdict = judge(model_, fit, key.covariance);
    if (!verdict.isTracked() || whose(key, now, fit) != Whose::patients) return std::nullopt;
    keys_.endMoment();
    return accepted(frame, fit, verdict);
  }

  // What the search finds is fitted to the end, and shown only if the skin is the patient's.
  Tracked<HeadPose> searchInFrame(const stereo::StereoFrame& frame,
                                  const std::optional<Eigen::Isometry3d>& expected) {
    if (!work_.leavesTimeToSearch()) return lost(first_loss_->reason, wordOfFirst(frame.captured));
    const std::array<ImagePyramid, 2> now = {ImagePyramid::coarse(frame.left),
                                             ImagePyramid::coarse(frame.right)};
    const auto found = search_.seek(keys_, now, last_ ? std::optional(last_->motion) : std::nullopt, expected,
                                    lost_frames_ == 0, work_);
    if (found.is_swapped) return lost(LostReason::camera, LossDetail::swapped);
    if (!found.is_to_be_tried) {
      const bool is_there = found.is_put_off || !last_;
      const auto detail = circumstance(is_there ? found.best.motion : last_->motion, now, frame.captured);
      return lost(LostReason::no_face, detail.value_or(wordWithoutFit(found)));
    }
    const auto there = attempt(frame, now, found.best.motion);
    if (there.verdict.isTracked()) return accepted(frame, there.fit, there.verdict);
    if (!there.fit.is_settled && there.fit.likeness > kGettingThere) search_.goOnFrom(there.fit.motion);
    return lost(*there.verdict.lost, detailOf(there, now, frame.captured));
  }

  struct Attempt {
    PoseFit fit;
    Verdict verdict;
  };

  Attempt attempt(const stereo::StereoFrame& frame, const std::array<ImagePyramid, 2>& now,
                  const Eigen::Isometry3d& start, bool is_known = false) {
    const KeyFrame& key = keys_.nearest(start);
    allowFor(key, start);
    const int level = search_.roughLevel() - 1, first_level = is_known ? kLevels - 1 : level;
    const PoseFit nearly = fitPose(rig_now_, model_, key.level, now, start, first_level, {}, level);
    work_.looks += nearly.looks;
    const auto finest = boxed(frame, nearly.motion);
    PoseFit fit =
        fitPose(rig_now_, model_, key.level, finest, nearly.motion, 0, trust(), 0, work_.stepsLeft(model_));
    work_.looks += fit.looks;
    Verdict verdict = judge(model_, fit, key.covariance, key.is_of_moment);
    if (!is_known && verdict.isTracked() && whose(key, finest, fit) != Whose::patients)
      verdict.lost = LostReason::no_face;
    return {std::move(fit), std::move(verdict)};
  }

  // In words only.
  LossDetail detailOf(const Attempt& there, const std::array<ImagePyramid, 2>& now,
                      Timestamp captured) const {
    if (const auto detail = circumstance(there.fit.motion, now, captured)) return *detail;
    return wordFor(*there.verdict.lost);
  }

  // Where patches look as they should, but too few, the rest is covered.
  static LossDetail wordFor(LostReason reason) {
    switch (reason) {
      case LostReason::camera:
        return LossDetail::one_camera;
      case LostReason::few_features:
        return LossDetail::covered;
      default:
        return LossDetail::doubtful;
    }
  }

  // While a fit waits for the next frame: what this one has shown so far, or what was said before.
  LossDetail wordWithoutFit(const FaceSearch::Found& found) const {
    if (!found.is_put_off) return found.is_anything_alike ? LossDetail::doubtful : LossDetail::not_found;
    if (first_loss_) return wordFor(first_loss_->reason);
    return lost_frames_ > 0 ? detail_ : LossDetail::doubtful;
  }

  // What the fit from the prediction has shown.
  LossDetail wordOfFirst(Timestamp captured) const {
    return isFar(first_loss_->motion, captured) ? LossDetail::too_far : wordFor(first_loss_->reason);
  }

  // What makes any face hard to see, wherever it is.
  std::optional<LossDetail> circumstance(const Eigen::Isometry3d& motion,
                                         const std::array<ImagePyramid, 2>& now, Timestamp captured) const {
    if (isFar(motion, captured)) return LossDetail::too_far;
    if (fineDetail(now[0], left_box_, model_.noise_grey).value_or(detail_at_start_) <
        kBlurred * detail_at_start_)
      return LossDetail::blurred;
    return std::nullopt;
  }

  // Nobody is far off who was near a moment ago: a fit that says so has caught on something else, a hand.
  bool isFar(const Eigen::Isometry3d& motion, Timestamp captured) const {
    const auto distanceAt = [&](const Eigen::Isometry3d& at) { return (at * model_.centre_mm).z(); };
    const double far_mm = kFar * model_.centre_mm.z();
    const bool may_be_far = !last_ || kNearlyFar * distanceAt(last_->motion) +
                                              kWalk_mm_s * std::max(0.0, captured - last_->captured) >
                                          far_mm;
    return may_be_far && distanceAt(motion) > far_mm;
  }

  // Pictures that are no news: the track goes on from before with the next good ones.
  Tracked<HeadPose> refused(LostReason fault) {
    detail_ = guard_.detail();
    return Lost{fault};
  }

  Tracked<HeadPose> lost(LostReason reason, LossDetail detail) {
    confirmation_ = Confirmation::none;
    detail_ = detail;
    ++lost_frames_;
    if (last_) last_->velocity.setZero(), last_->steady.setZero();
    keys_.forgetUnfinished();
    return Lost{reason};
  }

  // Not in a frame in which the head was looked for: that has cost enough.
  void learnSides(const stereo::StereoFrame& frame, const PoseFit& fit, const Verdict& verdict) {
    if (work_.looks > kLearnBelow_looks) return;
    KeyMotion moving;
    moving.velocity = velocityNow(frame.captured, fit);
    moving.allowed = offset_.late_s() * moving.velocity;
    stereo::StereoRig rig = rig_;
    rig.right_T_left = rightThatSees(fit.motion, moving.allowed);
    if (keys_.learn(rig, model_, frame, fit, verdict, moving))
      search_.add({ImagePyramid::coarse(frame.left), ImagePyramid::coarse(frame.right)}, fit.motion);
  }

  Tracked<HeadPose> accepted(const stereo::StereoFrame& frame, const PoseFit& fit, const Verdict& verdict) {
    learnTrust(frame.captured, fit);
    detail_ = LossDetail::unknown;
    remember(frame.captured, fit);
    HeadPose pose;
    pose.camera_T_head = RigidTransform<Camera, Head>::fromIsometry(fit.motion);
    pose.covariance = verdict.covariance;
    pose.face_centre = Point<Camera>(fit.motion * model_.centre_mm);
    pose.features = featuresOf(fit);
    pose.between_exposures_mm =
        last_->steady.tail<3>().norm() * (std::abs(offset_.late_s()) + offset_.sigma_s());
    left_box_ = boxOf(fit, 0), right_box_ = boxOf(fit, 1);
    pose.face_left = left_box_;
    return {pose, verdict.quality};
  }

  static std::vector<FaceFeature> featuresOf(const PoseFit& fit) {
    std::vector<FaceFeature> features;
    for (const auto& sight : fit.sights)
      if (sight[0].is_visible && sight[1].is_visible)
        features.push_back({sight[0].px.cast<double>(), sight[1].px.cast<double>(),
                            double(std::min(sight[0].weight, sight[1].weight))});
    return features;
  }

  static cv::Rect boxOf(const PoseFit& fit, int camera) {
    std::vector<cv::Point> points;
    for (const auto& sight : fit.sights)
      if (sight[camera].is_visible) points.emplace_back(int(sight[camera].px.x()), int(sight[camera].px.y()));
    return points.empty() ? cv::Rect() : cv::boundingRect(points);
  }

  // Skin that keeps wandering about the rigid fit (lips, jaw, lids) loses its say.
  void learnTrust(Timestamp captured, const PoseFit& fit) {
    const double dt_s = last_ ? std::clamp(captured - last_->captured, 0.0, 0.1) : 0.03;
    const double share = 1.0 - std::exp(-dt_s / kTrustMemory_s);
    for (std::size_t i = 0; i < wander_.size(); ++i) {
      double seen = -1.0;
      for (const auto& sight : fit.sights[i])
        if (sight.is_visible) seen = std::max(seen, std::min(double(sight.distance * sight.distance), 50.0));
      if (seen >= 0) wander_[i] += share * (std::max(0.0, seen - 4.0) - wander_[i]);
    }
  }

  Vector6d velocityTo(const PoseFit& fit, double since_s) const {
    const Eigen::Isometry3d step = last_->motion.inverse() * fit.motion;
    Vector6d velocity;
    velocity.head<3>() = logRotation(step.linear()) / since_s;
    velocity.tail<3>() = (step * model_.centre_mm - model_.centre_mm) / since_s;
    return velocity;
  }

  // The velocity of one frame carries the errors of two poses; fed back into the next they would grow.
  Vector6d steady(const Vector6d& velocity, double since_s) const {
    return last_->steady + (1.0 - std::exp(-since_s / kSteady_s)) * (velocity - last_->steady);
  }

  void remember(Timestamp captured, const PoseFit& fit) {
    Vector6d velocity = Vector6d::Zero();
    const double dt_s = last_ ? captured - last_->captured : 0.0;
    if (dt_s > 1e-4 && dt_s < kLongestGap_s) velocity = velocityTo(fit, dt_s);
    last_ = Last{fit.motion, velocity, last_ ? steady(velocity, dt_s) : velocity, captured};
    lost_frames_ = 0;
    search_.end();
  }

  std::shared_ptr<const FaceDetector> detector_;
  stereo::StereoRig rig_, rig_now_;  // now: as the moving head is seen (OffsetFilter)
  OffsetFilter offset_;
  Vector6d allowed_ = Vector6d::Zero();  // of the head's motion between the exposures, beyond the key frame's
  PatchModel model_;
  DetailAgreement both_cameras_;  // in the reference
  std::size_t asked_part_ = 0;
  KeyFrames keys_;
  FaceSearch search_;
  HeadWork work_;                        // in this frame so far
  int left_out_ = 0;                     // wanted of the next frame's
  std::optional<FirstLoss> first_loss_;  // of the fit from the prediction
  LossDetail detail_ = LossDetail::unknown;
  double detail_at_start_ = 0.0;
  FrameGuard guard_;
  std::optional<Last> last_;
  std::vector<double> wander_;  // per patch of level 0: mean square distance beyond the expected
  cv::Rect left_box_, right_box_;
  int lost_frames_ = 0;
  Pace pace_ = Pace::as_live;
  double beside_ms_ = 0.0;
  enum class Confirmation { none, wanted, asked };
  Confirmation confirmation_ = Confirmation::none;  // of a face found again by its patches
  bool was_gone_ = true;                            // before that question
  Timestamp confirmed_;                             // when it was asked last
  std::optional<Timestamp> other_seen_;             // another person's face
  int since_try_ = 0;                               // tracked frames by a moment's key frame
  std::unique_ptr<LostFace> lost_face_;             // last: its thread reads what stands above
};

}  // namespace

std::unique_ptr<HeadTracker> makeModelHeadTracker(std::shared_ptr<const FaceDetector> detector) {
  return std::make_unique<ModelHeadTracker>(std::move(detector));
}

}  // namespace facenav::tracking
