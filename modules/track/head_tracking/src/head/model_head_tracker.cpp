// "model": the default head tracker. Hundreds of skin patches give the pose in each frame (patch_track.h).
// This file applies the answers of the parallel recovery (recovery/lost_face.h) to the pose: a lost face was
// found again, a tracked face was checked, or no pose may be shown. The face detector runs at start only: it
// takes tens of milliseconds, while the search by the face's own images (coarse_search.h) finds it
// within a few frames of a few milliseconds each.

#include "facenav/anatomy/head_norms.h"
#include "facenav/face/stereo_face.h"
#include "facenav/head_tracking/head_tracker.h"
#include "frame_guard.h"
#include "patch_doubt.h"
#include "patch_track.h"
#include "recovery/face_check.h"
#include "recovery/lost_face.h"

namespace facenav::head_tracking {
namespace {

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
    patches_.start(rig, reference, region, surface);
    shown_.reset();
    left_out_ = 0;
    doubt_.clear();
    check_.start(reference.frame.captured);
    guard_.start(reference.frame);
    lost_face_ = std::make_unique<LostFace>(
        std::make_shared<FaceRecovery>(rig, reference.frame, region, surface, face, detector_),
        LostFace::Learnt{&patches_.camera().rig(), &patches_.model(), &patches_.bothCameras(),
                         &patches_.camera()},
        pace_);
    lost_face_->add(reference.key_frames);
  }

  HeadResult track(const cameras::StereoFrame& frame, const HeadContext& context) override {
    FACENAV_EXPECT(lost_face_ != nullptr, "track() before start()");
    if (context.is_learnt_in_doubt) forgetLearnt();
    if (context.right_T_left) patches_.moveRight(*context.right_T_left);
    if (frame.right_late_s) patches_.stateDelay(*frame.right_late_s);
    left_out_ = context.reserved.comparisons;
    HeadResult result = poseIn(frame);
    if (result)
      shown_ = frame.captured;
    else
      result.loss_detail = patches_.detail();
    result.exposure_offset = {patches_.camera().late_s(), patches_.camera().sigma_s()};
    result.work = patches_.work();
    result.beside_ms = beside_ms_;
    return result;
  }

  std::vector<FaceKeyFrame> learntKeyFrames() const override {
    return lost_face_ ? lost_face_->learnt() : std::vector<FaceKeyFrame>();
  }

 private:
  Tracked<HeadPose> poseIn(const cameras::StereoFrame& frame) {
    const double speed = patches_.motion().velocity().tail<3>().norm();
    const auto fault = guard_.check(frame, speed, patches_.leftBox(), patches_.rightBox());
    patches_.beginFrame(left_out_);
    beside_ms_ = 0.0;
    if (fault) return refused(*fault);
    const auto expected = patches_.expectedAt(frame.captured);
    if (expected)
      if (auto checked = answerOfCheck(frame)) return *checked;
    if (expected && patches_.isFollowing())
      if (auto followed = patches_.follow(*expected, frame)) {
        if (!followed->is_as_before_the_loss) checkIfDue(frame);
        return followed->pose;
      }
    return recover(frame, expected);
  }

  void forgetLearnt() {
    if (lost_face_) lost_face_->forget();
    check_.cancel();
    patches_.forgetLearnt();
    shown_.reset();
  }

  // Finds the head after the prediction has failed: from an answer about an earlier frame, then by the search
  // within the frame. If that fails, recovery is started in parallel.
  Tracked<HeadPose> recover(const cameras::StereoFrame& frame,
                            const std::optional<Eigen::Isometry3d>& expected) {
    if (const auto found = lost_face_->take(frame.captured))
      if (const auto answer = answerOf(*found, frame)) {
        if (!*answer) askBeside(frame);  // at once, so that the next answer comes a frame sooner
        return *answer;
      }
    const bool was_gone = patches_.motion().isKnown() && !expected;
    auto result = searchUnlessDoubted(frame, expected, was_gone);
    if (result && !was_gone) return result;
    if (result && pace_ != Pace::patient) {
      if (patches_.fitsAsExpected() && lost_face_->picturesKeepDetail()) {
        check_.faceReturned();
        return result;
      }
      result = doubted(PatchDoubt::kReturn, frame.captured);
    }
    askBeside(frame);
    if (pace_ == Pace::patient)
      if (const auto found = lost_face_->take(frame.captured)) result = answeredAtOnce(*found, frame, result);
    if (!result && patches_.detail() == LossDetail::doubtful && doubt_.wasOtherSeen(frame.captured))
      patches_.setDetail(LossDetail::other_face);
    return result;
  }

  void askBeside(const cameras::StereoFrame& frame) {
    lost_face_->ask(frame, patches_.motion());
    beside_ms_ = lost_face_->takeBeside_ms();
  }

  Tracked<HeadPose> searchUnlessDoubted(const cameras::StereoFrame& frame,
                                        const std::optional<Eigen::Isometry3d>& expected, bool was_gone) {
    if (const auto fault = doubt_.at(frame.captured)) return lost(fault->reason, fault->detail);
    const auto result = patches_.search(frame, expected, was_gone);
    if (!result) check_.cancel();
    return result;
  }

  // Applies the answer about this frame (Pace::patient). `result`: of the patches in this frame.
  Tracked<HeadPose> answeredAtOnce(const LostFace::Found& found, const cameras::StereoFrame& frame,
                                   const Tracked<HeadPose>& result) {
    if (!result || found.is_out_of_step || found.moment) return answerOf(found, frame).value_or(result);
    if (found.is_other) return doubted(PatchDoubt::kOtherFace, frame.captured);
    if (found.is_step_unsure) return doubted(PatchDoubt::kReturn, frame.captured);
    if (!found.is_patient && !patches_.fitsAsExpected() && found.face.identity.isAnswered())
      return doubted(PatchDoubt::kReturn, frame.captured);
    lost_face_->remember(found);
    return result;
  }

  // Applies an answer about a lost face to this frame. Returns nothing if it is undecided or from before the
  // loss.
  std::optional<Tracked<HeadPose>> answerOf(const LostFace::Found& found, const cameras::StereoFrame& frame) {
    // Not from patches_.motion(): it is the patches' own pose of an unconfirmed return, which was not shown.
    const bool is_before_the_loss = shown_ && found.captured.s < shown_->s;
    if (is_before_the_loss) return std::nullopt;
    doubt_.hear(found, frame.captured);
    if (found.is_out_of_step) return doubted(PatchDoubt::ofStep(found), frame.captured);
    if (!found.is_patient) return std::nullopt;
    return continueFrom(found, frame);
  }

  // Applies an answer about a tracked face: only evidence against it, and its new key frames after a return.
  std::optional<Tracked<HeadPose>> answerOfCheck(const cameras::StereoFrame& frame) {
    if (!check_.isAwaited()) return std::nullopt;
    const auto found = lost_face_->take(frame.captured);
    if (!found) {
      if (!lost_face_->isBusy()) check_.end();  // failed; the next check comes after the usual interval
      return std::nullopt;
    }
    check_.end();
    if (found->is_other) return doubted(PatchDoubt::kOtherFace, frame.captured);
    if (found->is_out_of_step) return doubted(PatchDoubt::ofStep(*found), frame.captured);
    if (found->is_step_unsure) {
      check_.askAgain();
      return std::nullopt;
    }
    const bool is_fresh = std::abs(frame.captured - found->captured) < kMoment_s;
    if (found->moment && check_.wasGone() && is_fresh && !patches_.isOfMoment())
      return continueFrom(*found, frame);
    lost_face_->remember(*found);
    return std::nullopt;
  }

  void checkIfDue(const cameras::StereoFrame& frame) {
    if (!check_.isDue(frame.captured, patches_.motion().speedBehind_mm_s(anatomy::kFaceToCortex_mm))) return;
    if (lost_face_->isBusy()) lost_face_->drop(frame.captured);  // started before a return
    if (lost_face_->isBusy()) return;
    lost_face_->ask(frame, patches_.motion());
    beside_ms_ = lost_face_->takeBeside_ms();
    check_.asked(frame.captured);
  }

  // Withholds the patches' poses from here on, until an answer confirms the face.
  Tracked<HeadPose> doubted(const PatchDoubt::Fault& fault, Timestamp now) {
    doubt_.start(fault, now);
    return lost(fault.reason, fault.detail);
  }

  // Continues from a pose that recovery found some frames ago.
  Tracked<HeadPose> continueFrom(const LostFace::Found& found, const cameras::StereoFrame& frame) {
    // An older answer (slow machine) gives pose and key frame, and the skin's identity is checked again.
    const bool is_fresh = std::abs(frame.captured - found.captured) < kMoment_s;
    const auto result = patches_.continueFrom(found.camera_T_head, found.moment, is_fresh, frame);
    result ? lost_face_->remember(found) : check_.cancel();
    return result;
  }

  // Refuses images without new information. The track continues with the next good ones.
  Tracked<HeadPose> refused(LostReason fault) {
    patches_.setDetail(guard_.detail());
    return Lost{fault};
  }

  Tracked<HeadPose> lost(LostReason reason, LossDetail detail) {
    check_.cancel();
    return patches_.lost(reason, detail);
  }

  std::shared_ptr<const face::FaceDetector> detector_;
  PatchTrack patches_;
  int left_out_ = 0;  // work of this frame reserved for another tracker
  FrameGuard guard_;
  std::optional<Timestamp> shown_;  // the last frame whose pose was returned
  Pace pace_ = Pace::as_live;
  double beside_ms_ = 0.0;
  FaceCheck check_;
  PatchDoubt doubt_;
  std::unique_ptr<LostFace> lost_face_;  // declared last: its thread reads the members above
};

}  // namespace

std::unique_ptr<HeadTracker> makeModelHeadTracker(std::shared_ptr<const face::FaceDetector> detector) {
  return std::make_unique<ModelHeadTracker>(std::move(detector));
}

}  // namespace facenav::head_tracking
