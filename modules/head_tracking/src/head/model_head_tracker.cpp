// "model": the default head tracker. Hundreds of skin patches, learnt from the reference frame and the dense
// cloud, fitted jointly in both images (pose_fit.h) from a constant-velocity prediction, always against the
// reference or a key frame made from it (key_frames.h), so nothing drifts. What is shown as tracked has
// passed the tests of track_verdict.h. Face detection runs at start only: a cascade takes tens of
// milliseconds, while the face's own pictures (coarse_search.h) find it again within a few frames of a few
// milliseconds each.

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "face_search.h"
#include "facenav/face/stereo_face.h"
#include "facenav/head_tracking/head_tracker.h"
#include "frame_guard.h"
#include "key_frames.h"
#include "late_camera.h"
#include "loss_words.h"
#include "patch_doubt.h"
#include "patch_model.h"
#include "patch_placement.h"
#include "patch_weights.h"
#include "pose_fit.h"
#include "recovery/face_check.h"
#include "recovery/lost_face.h"
#include "skin_detail.h"
#include "track_verdict.h"

namespace facenav::head_tracking {
namespace {

constexpr double kReach_mm = 150.0;    // of a sudden motion of the head, besides walking
constexpr double kGettingThere = 0.8;  // likeness of a fit that had not settled: the next frame goes on
constexpr int kLearnBelow_comparisons = 3400;  // at patches, in a frame
constexpr std::size_t kAskedParts = 8;         // of the patches, one a tracked frame: whose skin it is
constexpr int kLastingEvery = 20;  // tracked frames, between tries of the key frames from before a loss
constexpr double kSamePlace_mm = 0.4, kSameTurn_rad = 0.25 * M_PI / 180;  // between two kinds of key frames
constexpr double kAsExpected = 2.0;       // errors of patches, by those expected, on skin that has not moved
constexpr double kCortexDepth_mm = 80.0;  // from the face to what must not move unseen
// Age of an answer about a lost face. Its identity holds for the face there now up to kFresh_s. An older one
// (slow machine) gives pose and looks to start from, and the skin's identity is checked again.
constexpr double kFresh_s = 0.35, kOldest_s = 2.5;
constexpr double kFirstFrame_s = 0.03;
constexpr int kMargin_px = 20;  // about the patches' centres: half a patch, and the motion left to find

class ModelHeadTracker : public HeadTracker {
 public:
  explicit ModelHeadTracker(std::shared_ptr<const face::FaceDetector> detector)
      : detector_(detector ? std::move(detector) : face::makeFaceDetector()) {}

  using HeadTracker::start;
  using HeadTracker::track;

  void start(const cameras::StereoRig& rig, const HeadReference& reference, Pace pace) override {
    lost_face_.reset();
    pace_ = pace;
    const auto face = face::findStereoFace(*detector_, rig, reference.frame);
    if (!face && reference.surface.empty())
      throw Error("no face is found in both images of the reference frame", {},
                  "turn the face towards the cameras and light it evenly");
    const cv::Size size = reference.frame.left.size();
    const FaceRegion region =
        face ? FaceRegion(face->left, size) : FaceRegion(reference.surface_left_px, size);
    const FaceSurface surface =
        measureSurface(rig, reference, region, face ? face::depthOf(rig, *face) : 0.0);
    const std::array<ImagePyramid, 2> key = {ImagePyramid(reference.frame.left),
                                             ImagePyramid(reference.frame.right)};
    model_ = learnPatches(rig, reference.frame, key, region, surface);
    model_.shape_doubt = reference.surface.empty() ? 4.0 : 1.0;
    if (model_.level[0].patches.size() < 30)
      throw Error("no face with enough texture and depth is found in the reference frame", {},
                  "look for blur, darkness or a covered face");
    camera_ = LateCamera(rig, model_.centre_mm);
    both_cameras_ = detailOfBothCameras(model_);
    keys_ = KeyFrames(model_);
    search_ = FaceSearch(rig, model_, key, FaceTemplate(rig, region, surface, model_.centre_mm));
    left_box_ = right_box_ = face ? face->left.face : region.box();
    last_ = HeadMotion(model_.centre_mm);
    shown_.reset();
    patch_weights_ = PatchWeights(model_.level[0].patches.size());
    words_ = LossWords(model_.centre_mm, model_.noise_grey, key[0], left_box_);
    lost_frames_ = 0, asked_part_ = 0, left_out_ = 0, work_ = {};
    doubt_.clear();
    check_.start(reference.frame.captured);
    guard_.start(reference.frame);
    lost_face_ = std::make_unique<LostFace>(
        std::make_shared<FaceRecovery>(rig, reference.frame, region, surface, face, detector_),
        LostFace::Learnt{&camera_.rig(), &model_, &both_cameras_, &camera_}, pace_);
    lost_face_->add(reference.key_frames);
  }

  HeadResult track(const cameras::StereoFrame& frame, const HeadContext& context) override {
    FACENAV_EXPECT(lost_face_ != nullptr, "track() before start()");
    if (context.is_learnt_in_doubt) forgetLearnt();
    left_out_ = context.reserved.comparisons;
    HeadResult result = poseIn(frame);
    if (result)
      shown_ = frame.captured;
    else
      result.loss_detail = detail_;
    result.exposure_offset = {camera_.late_s(), camera_.sigma_s()};
    result.work = work_;
    result.beside_ms = beside_ms_;
    return result;
  }

  std::vector<FaceKeyFrame> learntKeyFrames() const override {
    return lost_face_ ? lost_face_->learnt() : std::vector<FaceKeyFrame>();
  }

 private:
  struct FirstLoss {
    LostReason reason;
    Eigen::Isometry3d motion;
  };

  Tracked<HeadPose> poseIn(const cameras::StereoFrame& frame) {
    const auto fault = guard_.check(frame, last_.velocity().tail<3>().norm(), left_box_, right_box_);
    const bool has_just_left = work_.left_out > 0;  // not twice running: a lost head has its turn, too
    work_ = {}, work_.left_out = has_just_left ? 0 : left_out_;
    beside_ms_ = 0.0;
    if (fault) return refused(*fault);
    first_loss_.reset();
    const bool is_recent = last_.isRecent(frame.captured);
    if (last_.isKnown() && !is_recent) last_.stopSteady();
    if (is_recent)
      if (auto checked = answerOfCheck(frame)) return *checked;
    if (is_recent && lost_frames_ == 0)
      if (auto tracked = trackFrom(last_.predicted(frame.captured), frame)) return *tracked;
    return recover(frame, is_recent ? std::optional(last_.predicted(frame.captured)) : std::nullopt);
  }

  void forgetLearnt() {
    if (lost_face_) lost_face_->forget();
    check_.cancel();
    keys_ = KeyFrames(model_);
    search_.forgetLearnt();
    patch_weights_.forget();
    last_.forget();
    shown_.reset();
    lost_frames_ = 0;
  }

  std::optional<Eigen::Isometry3d> lastPose() const {
    return last_.isKnown() ? std::optional(last_.pose()) : std::nullopt;
  }

  // The fit from the prediction. Nothing where it does not hold; first_loss_ says why.
  std::optional<Tracked<HeadPose>> trackFrom(const Eigen::Isometry3d& predicted,
                                             const cameras::StereoFrame& frame) {
    const KeyFrame& key = keys_.nearest(predicted);
    camera_.allowFor(key, predicted, last_.steady());
    const auto now = boxed(frame, predicted);
    const PoseFit fit =
        fitPose(camera_.now(), model_, key.level, now, predicted, 0, patch_weights_.weights());
    work_.comparisons += fit.comparisons;
    const Verdict verdict = verdictOf(key, fit);
    if (!verdict.isTracked() || isOtherPerson(key, now, fit)) {
      first_loss_ = {verdict.lost.value_or(LostReason::no_face), fit.motion};
      return std::nullopt;
    }
    if (const auto before = asBeforeTheLoss(frame, now, fit)) return before;
    const Verdict whole = camera_.learn(key, fit, last_, frame.captured, verdict);
    learnSides(frame, fit, whole);  // ends the life of `key`
    auto pose = accepted(frame, fit, whole);
    checkIfDue(frame);
    return pose;
  }

  Verdict verdictOf(const KeyFrame& key, const PoseFit& fit) const {
    Verdict verdict = judge(model_, fit, key.covariance, key.is_of_moment);
    verdict.unseen_covariance = key.unseen_covariance;
    return verdict;
  }

  // Level 0 of the parts of both images where the face is expected.
  std::array<ImagePyramid, 2> boxed(const cameras::StereoFrame& frame,
                                    const Eigen::Isometry3d& motion) const {
    const auto boxes = boxesAt(camera_.rig(), model_, motion, kMargin_px);
    std::array<ImagePyramid, 2> now;
    now[0].level[0] = blurredPart(frame.left, boxes[0]);
    now[1].level[0] = blurredPart(frame.right, boxes[1]);
    return now;
  }

  // Somebody else, put in the patient's place between two frames. A part of the patches is asked in each, all
  // of them where that part is in doubt.
  bool isOtherPerson(const KeyFrame& key, const std::array<ImagePyramid, 2>& now, const PoseFit& fit) {
    asked_part_ = (asked_part_ + 1) % kAskedParts;
    return identityAt(key, now, fit, {kAskedParts, asked_part_}) != SkinIdentity::patient &&
           identityAt(key, now, fit) == SkinIdentity::other_person;
  }

  SkinIdentity identityAt(const KeyFrame& key, const std::array<ImagePyramid, 2>& now, const PoseFit& fit,
                          const PatchShare& share = {}) const {
    return identityOfSkin(detailAgreement(camera_.now(), model_, key.level[0], now, fit, share),
                          both_cameras_);
  }

  // The prediction failed. An answer about an earlier frame comes first, then the search within the frame;
  // what it does not find is asked for beside the frames.
  Tracked<HeadPose> recover(const cameras::StereoFrame& frame,
                            const std::optional<Eigen::Isometry3d>& expected) {
    if (const auto found = lost_face_->take(frame.captured))
      if (const auto answer = answerOf(*found, frame)) {
        if (!*answer) askBeside(frame);  // at once: the next answer comes a frame sooner
        return *answer;
      }
    const bool was_gone = last_.isKnown() && !expected;
    auto result = searchUnlessDoubted(frame, expected, was_gone);
    if (result && !was_gone) return result;
    if (result && pace_ != Pace::patient) {
      if (fit_scale_ < kAsExpected && lost_face_->picturesKeepDetail()) {
        check_.faceReturned();
        return result;
      }
      result = doubted(PatchDoubt::kReturn, frame.captured);
    }
    askBeside(frame);
    if (pace_ == Pace::patient)
      if (const auto found = lost_face_->take(frame.captured)) result = answeredAtOnce(*found, frame, result);
    if (!result && detail_ == LossDetail::doubtful && doubt_.wasOtherSeen(frame.captured))
      detail_ = LossDetail::other_face;
    return result;
  }

  void askBeside(const cameras::StereoFrame& frame) {
    lost_face_->ask(frame, lastPose());
    beside_ms_ = lost_face_->takeBeside_ms();
  }

  Tracked<HeadPose> searchUnlessDoubted(const cameras::StereoFrame& frame,
                                        const std::optional<Eigen::Isometry3d>& expected, bool was_gone) {
    if (const auto fault = doubt_.at(frame.captured)) return lost(fault->reason, fault->detail);
    keys_.preferMoment((lost_frames_ % 2 == 0) != was_gone);
    auto result = searchInFrame(frame, expected);
    keys_.preferMoment(true);
    return result;
  }

  // Pace::patient: the answer about this frame. `result`: what the patches found in it.
  Tracked<HeadPose> answeredAtOnce(const LostFace::Found& found, const cameras::StereoFrame& frame,
                                   const Tracked<HeadPose>& result) {
    if (!result || found.is_out_of_step || found.moment) return answerOf(found, frame).value_or(result);
    if (found.is_other) return doubted(PatchDoubt::kOtherFace, frame.captured);
    if (found.is_step_unsure) return doubted(PatchDoubt::kReturn, frame.captured);
    if (!found.is_patient && fit_scale_ >= kAsExpected && found.face.identity.isAnswered())
      return doubted(PatchDoubt::kReturn, frame.captured);
    lost_face_->remember(found);
    return result;
  }

  // What an answer about a lost face says of this frame; nothing where it says too little, or is too old.
  std::optional<Tracked<HeadPose>> answerOf(const LostFace::Found& found, const cameras::StereoFrame& frame) {
    if (std::abs(frame.captured - found.captured) > kOldest_s) return std::nullopt;
    // Not by last_: the patches' own pose of a doubtful return is kept there, and was not shown.
    const bool is_before_the_loss = shown_ && found.captured.s < shown_->s;
    if (is_before_the_loss) return std::nullopt;
    doubt_.hear(found, frame.captured);
    if (found.is_out_of_step) return doubted(PatchDoubt::kOutOfStep, frame.captured);
    if (!found.is_patient) return std::nullopt;
    return continueFrom(found, frame);
  }

  // Of a face that is tracked: only what speaks against it counts, and its new looks after a return.
  std::optional<Tracked<HeadPose>> answerOfCheck(const cameras::StereoFrame& frame) {
    if (!check_.isAwaited()) return std::nullopt;
    const auto found = lost_face_->take(frame.captured);
    if (!found) {
      if (!lost_face_->isBusy()) check_.end();  // it failed; the next one is asked in its time
      return std::nullopt;
    }
    check_.end();
    if (found->is_other) return doubted(PatchDoubt::kOtherFace, frame.captured);
    if (found->is_out_of_step) return doubted(PatchDoubt::kOutOfStep, frame.captured);
    if (found->is_step_unsure) {
      check_.askAgain();
      return std::nullopt;
    }
    const bool is_fresh = std::abs(frame.captured - found->captured) < kFresh_s;
    if (found->moment && check_.wasGone() && is_fresh && !keys_.isOfMoment())
      return continueFrom(*found, frame);
    lost_face_->remember(*found);
    return std::nullopt;
  }

  void checkIfDue(const cameras::StereoFrame& frame) {
    if (!check_.isDue(frame.captured, last_.speedBehind_mm_s(kCortexDepth_mm))) return;
    if (lost_face_->isBusy()) lost_face_->drop(frame.captured);  // asked before a return
    if (lost_face_->isBusy()) return;
    lost_face_->ask(frame, last_.pose());
    beside_ms_ = lost_face_->takeBeside_ms();
    check_.asked(frame.captured);
  }

  // From here on the patches show nothing until an answer clears the face.
  Tracked<HeadPose> doubted(const PatchDoubt::Fault& fault, Timestamp now) {
    doubt_.start(fault, now);
    return lost(fault.reason, fault.detail);
  }

  // From what was found beside the frames, some frames ago.
  Tracked<HeadPose> continueFrom(const LostFace::Found& found, const cameras::StereoFrame& frame) {
    const double since_s = std::max(0.0, frame.captured - last_.captured());
    if (last_.isKnown() && (found.camera_T_head * model_.centre_mm - last_.pose() * model_.centre_mm).norm() >
                               kReach_mm + kWalk_mm_s * since_s)
      return lost(LostReason::no_face, LossDetail::doubtful);  // faster than a person moves
    if (found.moment)
      keys_.startMoment(*found.moment);
    else
      keys_.endMoment();
    const std::array<ImagePyramid, 2> now = {ImagePyramid::coarse(frame.left),
                                             ImagePyramid::coarse(frame.right)};
    const bool is_fresh = std::abs(frame.captured - found.captured) < kFresh_s;
    const auto there = attempt(frame, now, found.camera_T_head, {is_fresh, true});
    if (!there.verdict.isTracked()) {
      keys_.endMoment();
      return lost(*there.verdict.lost, detailOf(there, now, frame.captured));
    }
    lost_face_->remember(found);
    return accepted(frame, there.fit, there.verdict);
  }

  // The head is tracked by what it looked like when it was found anew. Where the patches learnt before the
  // loss fit again, too, they are the better ones: nothing lies between them and the reference.
  std::optional<Tracked<HeadPose>> asBeforeTheLoss(const cameras::StereoFrame& frame,
                                                   const std::array<ImagePyramid, 2>& now,
                                                   const PoseFit& by_moment) {
    if (!keys_.isOfMoment() || ++since_try_ % kLastingEvery != 0) return std::nullopt;
    const KeyFrame& key = keys_.lasting(by_moment.motion);
    const PoseFit fit =
        fitPose(camera_.now(), model_, key.level, now, by_moment.motion, 0, patch_weights_.weights());
    work_.comparisons += fit.comparisons;
    const Eigen::Isometry3d off = by_moment.motion.inverse() * fit.motion;
    const bool is_same = (off * model_.centre_mm - model_.centre_mm).norm() < kSamePlace_mm &&
                         rotationAngle(off.linear()) < kSameTurn_rad;
    if (!is_same && fit.scale > kAsExpected) return std::nullopt;
    const Verdict verdict = verdictOf(key, fit);
    if (!verdict.isTracked() || identityAt(key, now, fit) != SkinIdentity::patient) return std::nullopt;
    keys_.endMoment();
    return accepted(frame, fit, verdict);
  }

  // What the search finds is fitted to the end, and shown only if the skin is the patient's.
  Tracked<HeadPose> searchInFrame(const cameras::StereoFrame& frame,
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
    const auto there = attempt(frame, now, found.best.motion);
    if (there.verdict.isTracked()) return accepted(frame, there.fit, there.verdict);
    if (!there.fit.is_settled && there.fit.likeness > kGettingThere) search_.goOnFrom(there.fit.motion);
    return lost(*there.verdict.lost, detailOf(there, now, frame.captured));
  }

  struct Attempt {
    PoseFit fit;
    Verdict verdict;
  };
  struct Known {
    bool is_patient;  // the skin need not be asked
    bool is_rough;    // the start is some frames old
  };

  Attempt attempt(const cameras::StereoFrame& frame, const std::array<ImagePyramid, 2>& now,
                  const Eigen::Isometry3d& start, const Known& known = {false, false}) {
    const KeyFrame& key = keys_.nearest(start);
    camera_.allowFor(key, start, last_.steady());
    const int level = search_.roughLevel() - 1, first_level = known.is_rough ? kLevels - 1 : level;
    const PoseFit nearly = fitPose(camera_.now(), model_, key.level, now, start, first_level, {}, level);
    work_.comparisons += nearly.comparisons;
    const auto finest = boxed(frame, nearly.motion);
    PoseFit fit = fitPose(camera_.now(), model_, key.level, finest, nearly.motion, 0,
                          patch_weights_.weights(), 0, work_.stepsLeft(model_));
    work_.comparisons += fit.comparisons;
    Verdict verdict = verdictOf(key, fit);
    if (!known.is_patient && verdict.isTracked() && identityAt(key, finest, fit) != SkinIdentity::patient)
      verdict.lost = LostReason::no_face;
    return {std::move(fit), std::move(verdict)};
  }

  // Only words follow: no function below up to wordOfFirst() changes the track.
  LossDetail detailOf(const Attempt& there, const std::array<ImagePyramid, 2>& now,
                      Timestamp captured) const {
    return words_.circumstance(there.fit.motion, now[0], left_box_, last_, captured)
        .value_or(LossWords::of(*there.verdict.lost));
  }

  // While a fit waits for the next frame: what this one has shown so far, or what was said before.
  LossDetail wordWithoutFit(const FaceSearch::Found& found) const {
    if (!found.is_deferred) return found.is_anything_alike ? LossDetail::doubtful : LossDetail::not_found;
    if (first_loss_) return LossWords::of(first_loss_->reason);
    return lost_frames_ > 0 ? detail_ : LossDetail::doubtful;
  }

  // What the fit from the prediction has shown.
  LossDetail wordOfFirst(Timestamp captured) const {
    return words_.isFar(first_loss_->motion, last_, captured) ? LossDetail::too_far
                                                              : LossWords::of(first_loss_->reason);
  }

  // Pictures that are no news: the track goes on from before with the next good ones.
  Tracked<HeadPose> refused(LostReason fault) {
    detail_ = guard_.detail();
    return Lost{fault};
  }

  Tracked<HeadPose> lost(LostReason reason, LossDetail detail) {
    check_.cancel();
    detail_ = detail;
    ++lost_frames_;
    last_.stop();
    keys_.forgetUnfinished();
    return Lost{reason};
  }

  // Not in a frame in which the head was looked for: that has cost enough.
  void learnSides(const cameras::StereoFrame& frame, const PoseFit& fit, const Verdict& verdict) {
    if (work_.comparisons > kLearnBelow_comparisons) return;
    const KeyMotion moving = camera_.motionOf(last_.steadyWith(fit.motion, frame.captured));
    if (keys_.learn(camera_.rigFor(fit.motion, moving), model_, frame, fit, verdict, moving))
      search_.add({ImagePyramid::coarse(frame.left), ImagePyramid::coarse(frame.right)}, fit.motion);
  }

  Tracked<HeadPose> accepted(const cameras::StereoFrame& frame, const PoseFit& fit, const Verdict& verdict) {
    patch_weights_.learn(fit, last_.isKnown() ? frame.captured - last_.captured() : kFirstFrame_s);
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
    left_box_ = boxOf(fit, 0), right_box_ = boxOf(fit, 1);
    pose.face_left = left_box_;
    return {pose, verdict.quality};
  }

  static std::vector<FaceFeature> featuresOf(const PoseFit& fit) {
    std::vector<FaceFeature> features;
    for (const auto& measurement : fit.measurements)
      if (measurement[0].is_visible && measurement[1].is_visible)
        features.push_back({measurement[0].px.cast<double>(), measurement[1].px.cast<double>(),
                            double(std::min(measurement[0].weight, measurement[1].weight))});
    return features;
  }

  static cv::Rect boxOf(const PoseFit& fit, int camera) {
    std::vector<cv::Point> points;
    for (const auto& measurement : fit.measurements)
      if (measurement[camera].is_visible)
        points.emplace_back(int(measurement[camera].px.x()), int(measurement[camera].px.y()));
    return points.empty() ? cv::Rect() : cv::boundingRect(points);
  }

  std::shared_ptr<const face::FaceDetector> detector_;
  LateCamera camera_;
  PatchModel model_;
  DetailAgreement both_cameras_;  // in the reference
  std::size_t asked_part_ = 0;
  KeyFrames keys_;
  FaceSearch search_;
  HeadWork work_;                        // in this frame so far
  int left_out_ = 0;                     // wanted of the next frame's
  std::optional<FirstLoss> first_loss_;  // of the fit from the prediction
  LossWords words_;
  LossDetail detail_ = LossDetail::unknown;
  FrameGuard guard_;
  HeadMotion last_;
  std::optional<Timestamp> shown_;  // the last frame whose pose was given
  PatchWeights patch_weights_;
  cv::Rect left_box_, right_box_;
  int lost_frames_ = 0;
  Pace pace_ = Pace::as_live;
  double beside_ms_ = 0.0;
  FaceCheck check_;
  PatchDoubt doubt_;
  double fit_scale_ = 0.0;               // of the last fit that was accepted
  int since_try_ = 0;                    // tracked frames by a moment's key frame
  std::unique_ptr<LostFace> lost_face_;  // last: its thread reads what stands above
};

}  // namespace

std::unique_ptr<HeadTracker> makeModelHeadTracker(std::shared_ptr<const face::FaceDetector> detector) {
  return std::make_unique<ModelHeadTracker>(std::move(detector));
}

}  // namespace facenav::head_tracking
