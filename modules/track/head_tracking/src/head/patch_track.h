#pragma once
// PatchTrack: the head's pose from its skin patches, frame by frame. They are fitted jointly in both images
// (pose_fit.h), starting from a constant-velocity prediction, always against the reference or a key frame
// made from it (key_frames.h), so there is no drift. If that fails, the frame is searched (face_search.h). A
// pose is returned only if it passes the tests of track_verdict.h and the skin is the patient's. Work in
// parallel with the frames belongs to the tracker (model_head_tracker.cpp).

#include <array>
#include <optional>

#include "face_search.h"
#include "facenav/head_tracking/head_tracker.h"
#include "key_frames.h"
#include "late_camera.h"
#include "loss_words.h"
#include "patch_model.h"
#include "patch_weights.h"
#include "skin_detail.h"

namespace facenav::head_tracking {

class PatchTrack {
 public:
  PatchTrack() = default;
  PatchTrack(const PatchTrack&) = delete;  // the search points to the model
  PatchTrack& operator=(const PatchTrack&) = delete;

  /// Learns the patches of the face in `region` of the left reference image. Throws Error if the reference
  /// shows too few patches.
  void start(const cameras::StereoRig& rig, const HeadReference& reference, const FaceRegion& region,
             const FaceSurface& surface);
  /// Discards everything learnt since start(), because it is in doubt.
  void forgetLearnt();

  /// Call first in each frame. `reserved`: patch comparisons to leave for another tracker.
  void beginFrame(int reserved);
  /// The predicted pose; nullopt if the last one is unknown or too old. Call it once in each usable frame.
  std::optional<Eigen::Isometry3d> expectedAt(Timestamp captured);

  struct Followed {
    Tracked<HeadPose> pose;
    bool is_as_before_the_loss;  // the patches learnt before a loss fit again
  };
  /// The fit from the prediction. nullopt if it is rejected; search() then gives the reason.
  std::optional<Followed> follow(const Eigen::Isometry3d& predicted, const cameras::StereoFrame& frame);
  /// Searches the head in the frame, within the rest of its work budget. `was_gone`: lost for longer than a
  /// prediction lasts.
  Tracked<HeadPose> search(const cameras::StereoFrame& frame,
                           const std::optional<Eigen::Isometry3d>& expected, bool was_gone);
  /// Continues from a pose that recovery found, with the key frame `moment` if the face looks different now.
  /// `is_fresh`: the pose is so recent that its identity check is still valid.
  Tracked<HeadPose> continueFrom(const Eigen::Isometry3d& camera_T_head,
                                 const std::optional<KeyFrame>& moment, bool is_fresh,
                                 const cameras::StereoFrame& frame);
  /// Ends the track. Later frames search.
  Tracked<HeadPose> lost(LostReason reason, LossDetail detail);

  void moveRight(const RigidTransform<RightCamera, Camera>& right_T_left) { camera_.moveRight(right_T_left); }
  /// Sets the right camera's delay in this frame by the drivers' time stamps, s.
  void stateDelay(double late_s) { camera_.state(late_s); }
  const LateCamera& camera() const { return camera_; }
  const PatchModel& model() const { return model_; }
  const DetailAgreement& bothCameras() const { return both_cameras_; }
  const HeadMotion& motion() const { return last_; }
  std::optional<Eigen::Isometry3d> lastPose() const;
  bool isFollowing() const { return lost_frames_ == 0; }
  /// True if tracked by a temporary key frame, made when the face was found again.
  bool isOfMoment() const { return keys_.isOfMoment(); }
  /// True if the last accepted fit has the residuals of skin that has not moved.
  bool fitsAsExpected() const;
  const FrameWork& work() const { return work_; }
  const cv::Rect& leftBox() const { return left_box_; }
  const cv::Rect& rightBox() const { return right_box_; }
  LossDetail detail() const { return detail_; }
  void setDetail(LossDetail detail) { detail_ = detail; }

 private:
  struct FirstLoss {
    LostReason reason;
    Eigen::Isometry3d motion;
  };
  struct Attempt {
    PoseFit fit;
    Verdict verdict;
  };
  struct Known {
    bool is_patient;  // the identity check is already done
    bool is_rough;    // the start is some frames old
  };

  Verdict verdictOf(const KeyFrame& key, const PoseFit& fit) const;
  std::array<ImagePyramid, 2> boxed(const cameras::StereoFrame& frame, const Eigen::Isometry3d& motion) const;
  bool isOtherPerson(const KeyFrame& key, const std::array<ImagePyramid, 2>& now, const PoseFit& fit);
  SkinIdentity identityAt(const KeyFrame& key, const std::array<ImagePyramid, 2>& now, const PoseFit& fit,
                          const PatchShare& share = {}) const;
  std::optional<Tracked<HeadPose>> asBeforeTheLoss(const cameras::StereoFrame& frame,
                                                   const std::array<ImagePyramid, 2>& now,
                                                   const PoseFit& by_moment);
  Tracked<HeadPose> searchInFrame(const cameras::StereoFrame& frame,
                                  const std::optional<Eigen::Isometry3d>& expected);
  Attempt attempt(const cameras::StereoFrame& frame, const std::array<ImagePyramid, 2>& now,
                  const Eigen::Isometry3d& start, const Known& known);
  LossDetail detailOf(const Attempt& there, const std::array<ImagePyramid, 2>& now, Timestamp captured) const;
  LossDetail wordWithoutFit(const FaceSearch::Found& found) const;
  LossDetail wordOfFirst(Timestamp captured) const;
  void learnSides(const cameras::StereoFrame& frame, const PoseFit& fit, const Verdict& verdict);
  std::optional<health::RightPoseObservation> rightCamera(const PoseFit& fit, const Verdict& verdict) const;
  Tracked<HeadPose> accepted(const cameras::StereoFrame& frame, const PoseFit& fit, const Verdict& verdict);

  LateCamera camera_;
  PatchModel model_;
  DetailAgreement both_cameras_;  // agreement in the reference
  std::size_t asked_part_ = 0;
  KeyFrames keys_;
  FaceSearch search_;
  HeadWork work_;                        // of this frame so far
  std::optional<FirstLoss> first_loss_;  // loss of the fit from the prediction
  LossWords words_;
  LossDetail detail_ = LossDetail::unknown;
  HeadMotion last_;
  PatchWeights patch_weights_;
  cv::Rect left_box_, right_box_;
  int lost_frames_ = 0;
  double fit_scale_ = 0.0;  // scale of the last accepted fit
  int since_try_ = 0;       // frames tracked by a temporary key frame
};

}  // namespace facenav::head_tracking
