#pragma once
// LostFace: asks FaceRecovery about lost frames, beside the frames, and makes of its answer what the tracker
// goes on from: a pose near which the patches learnt before serve, or these patches learnt anew as the face
// looks now.

#include <memory>
#include <optional>

#include "face_recovery.h"
#include "facenav/core/later_answer.h"
#include "facenav/head_tracking/head_tracker.h"
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
    std::optional<KeyFrame> moment;  // the face as it looks now; nothing where the reference's patches serve
    bool is_patient = false;         // else the face there is another's, or nobody's, or not sure
    bool is_other = false;
    bool is_out_of_step = false;  // the two pictures show the face at two poses
    bool is_step_unsure = false;  // they may do so: the next answer decides
    RecoveredFace face;
    Timestamp captured;          // of the pair it was found in
    cameras::StereoFrame frame;  // that pair, where it is the patient's
    int epoch = 0;

    void identify();  // is_patient, is_other and is_out_of_step from `face`
  };

  LostFace(std::shared_ptr<FaceRecovery> recovery, const Learnt& learnt, Pace pace);

  /// The answer about an earlier frame (with Pace::patient, about this one), if there is one and nothing was
  /// forgotten since. On a slow machine it may be seconds old: `captured` says of when it is.
  std::optional<Found> take(Timestamp now);
  /// An answer that has come is thrown away.
  void drop(Timestamp now) { answers_.take(now.s); }
  bool isBusy() const { return answers_.isBusy(); }
  /// A frame whose face is lost, or is to be checked. `last`: where the head was seen last. Nothing is asked
  /// while an answer is awaited.
  void ask(const cameras::StereoFrame& frame, const std::optional<Eigen::Isometry3d>& last);
  /// Whether the pictures hold the skin's fine detail, so that patches alone tell whose skin it is.
  bool picturesKeepDetail() const;
  /// The face is tracked as it was found: how it looks is remembered, where that is new.
  void remember(const Found& found);
  /// Looks from elsewhere, to be searched for, too.
  void add(const std::vector<FaceKeyFrame>& looks);
  /// Remembered so far and sure enough to be kept.
  std::vector<FaceKeyFrame> learnt() const { return recovery_->learnt(); }
  /// What was asked and learnt so far is in doubt.
  void forget();
  /// Time that this thread has spent since the last call on what a live session does beside the frames (ms).
  double takeBeside_ms();

 private:
  struct Question {
    cameras::StereoFrame frame;
    std::optional<Eigen::Isometry3d> last;
    bool is_thorough;  // with a search for faces at any roll
    int epoch;
  };
  struct Before {
    Eigen::Isometry3d camera_T_head;
    Timestamp captured;
  };
  double allowed_px(const Found& found);
  static Found answer(const FaceRecovery& recovery, const Learnt& learnt, const Question& question);
  static void learnMoment(const FaceRecovery& recovery, const Learnt& learnt, Found& found);

  std::shared_ptr<FaceRecovery> recovery_;
  Learnt learnt_;
  std::optional<Before> before_;  // of the last answer
  StepWatch step_;
  Pace pace_;
  int epoch_ = 0, asked_ = 0;
  bool is_to_forget_ = false;
  double beside_ms_ = 0.0;
  LaterAnswer<Question, Found> answers_;  // last: its thread ends first
};

}  // namespace facenav::head_tracking
