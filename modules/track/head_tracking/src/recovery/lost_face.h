#pragma once
// LostFace: passes lost frames to FaceRecovery, in parallel with the frames. Its answer is a pose from which
// the tracker continues: known patches fit near it, or new patches are made from the present image.

#include <memory>
#include <optional>

#include "face_recovery.h"
#include "facenav/core/later_answer.h"
#include "facenav/head_tracking/head_tracker.h"
#include "facenav/health/pair_diagnosis.h"
#include "head/head_motion.h"
#include "head/key_frames.h"
#include "head/late_camera.h"
#include "head/skin_detail.h"

namespace facenav::head_tracking {

class LostFace {
 public:
  /// What the tracker learnt at its start; all must outlive this.
  struct Learnt {
    const cameras::StereoRig* rig;
    const PatchModel* model;
    const DetailAgreement* both_cameras;
    const LateCamera* late;  // read by the tracker's thread only
  };
  struct Found {
    Eigen::Isometry3d camera_T_head = Eigen::Isometry3d::Identity();
    std::optional<KeyFrame> moment;  // patches of the present image; empty if the reference's fit
    bool is_patient = false;         // otherwise the face is another person's, absent, or undecided
    bool is_other = false;
    bool is_out_of_step = false;                               // the two images show the face at two poses
    health::OffsetCause cause = health::OffsetCause::unknown;  // of is_out_of_step
    bool is_step_unsure = false;  // the images may be out of step: the next answer decides
    RecoveredFace face;
    Timestamp captured;          // capture time of the pair
    cameras::StereoFrame frame;  // that pair, only if the face is the patient's
    int epoch = 0;
    std::optional<health::OffsetCause> diagnosed;  // of this pair

    void identify();  // sets is_patient, is_other and is_out_of_step from `face`
  };

  LostFace(std::shared_ptr<FaceRecovery> recovery, const Learnt& learnt, Pace pace);

  /// The answer about an earlier frame (with Pace::patient, about this one), unless forget() was called since
  /// the question. On a slow machine it may be seconds old: see `captured`.
  std::optional<Found> take(Timestamp now);
  /// Discards an answer that has arrived.
  void drop(Timestamp now) { answers_.take(now.s); }
  bool isBusy() const { return answers_.isBusy(); }
  /// Starts a search in a frame whose face is lost or to be checked. `last`: the head's last motion. Does
  /// nothing while an answer is pending.
  void ask(const cameras::StereoFrame& frame, const HeadMotion& last);
  /// True if the images keep the skin's fine detail, so that patches alone decide the identity.
  bool picturesKeepDetail() const;
  /// Keeps the tracked face as a key frame if it looks new.
  void remember(const Found& found);
  /// Adds key frames from another source to the search.
  void add(const std::vector<FaceKeyFrame>& keys);
  /// Key frames that are reliable enough to be saved.
  std::vector<FaceKeyFrame> learnt() const { return recovery_->learnt(); }
  /// Discards the key frames and pending questions, because they are in doubt.
  void forget();
  /// Processor time since the last call that a live session would spend in parallel with the frames (ms).
  double takeBeside_ms();

 private:
  struct Question {
    cameras::StereoFrame frame;
    std::optional<Eigen::Isometry3d> last;
    bool is_thorough;   // the face detector searches all roll angles
    bool is_diagnosed;  // images off their lines are diagnosed, which takes 0.3 s more
    int epoch;
    cameras::StereoRig rig;  // with the right camera's pose in this frame
  };
  struct Before {
    Eigen::Isometry3d camera_T_head;
    Timestamp captured;
  };
  std::optional<Eigen::Isometry3d> startAfter(const HeadMotion& last) const;
  double allowed_px(const Found& found);
  static Found answer(const FaceRecovery& recovery, const Learnt& learnt, const Question& question);
  void explainOffset(Found& found);
  static void learnMoment(const FaceRecovery& recovery, const Learnt& learnt, const cameras::StereoRig& rig,
                          Found& found);

  std::shared_ptr<FaceRecovery> recovery_;
  Learnt learnt_;
  std::optional<Before> before_;  // pose and time of the last answer
  std::optional<Before> seen_;  // of the last that is likely the patient, if perhaps not sure enough to show
  StepWatch step_;
  health::OffsetCause cause_ = health::OffsetCause::unknown;  // by the last diagnosis
  std::optional<Timestamp> diagnosed_;  // capture time of the pair that was diagnosed last
  Pace pace_;
  int epoch_ = 0, asked_ = 0;
  bool is_to_forget_ = false;
  double beside_ms_ = 0.0;
  LaterAnswer<Question, Found> answers_;  // declared last, so that its thread ends first
};

}  // namespace facenav::head_tracking
