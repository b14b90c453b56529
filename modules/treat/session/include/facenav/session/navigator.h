#pragma once
// Navigator: one stereo frame in, one NavigationState out (the TREAT arrow of the data flow), synchronous.
// Command line, demo and live thread use it. Head = Camera at the reference frame, so head_T_mri equals
// camera_T_mri at that moment and stays fixed; per frame camera_T_mri = camera_T_head * head_T_mri.

#include <memory>
#include <optional>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/casefile/face_looks.h"
#include "facenav/guidance/coil_plate.h"
#include "facenav/guidance/guidance.h"
#include "facenav/monitoring/pose_trust.h"
#include "facenav/monitoring/surface_beside_coil.h"
#include "facenav/session/navigation_state.h"

namespace facenav::session {

struct NavigatorSetup {
  cameras::StereoRig rig;
  head_tracking::HeadReference reference;
  /// Alignment at the time of the reference frame. Empty: the head is tracked, but not placed in the MRI.
  std::optional<RigidTransform<Camera, Mri>> camera_T_mri_at_reference;
  coil_tracking::CoilModel coil;
  guidance::Tolerance tolerance;
  /// The aligned skin, for the drift watchdog; null: no watchdog.
  std::shared_ptr<const registration::ScalpField> scalp = nullptr;
  /// The coil's contact outline; around it the live surface is measured, while `pace` is live.
  guidance::CoilPlate plate = guidance::figureOfEight();
  /// Schedule of work that takes longer than a frame: the drift watchdog, recovery of a lost face.
  head_tracking::Pace pace = head_tracking::Pace::as_live;
  /// Key frames of the patient's face from earlier sessions; used if the head is placed in the MRI.
  std::vector<casefile::StoredKeyFrame> key_frames = {};
  /// Head, or coil, are tracked by another tracker than the cameras (NavigationState). With a served head
  /// there are no pictures.
  bool is_head_served = false, is_coil_served = false;
  /// A second coil that is tracked at once; whoever makes the navigator calls addSecondCoil with it.
  std::optional<coil_tracking::CoilModel> second_coil = {};
};

/// Distance of the contact face's centre from the MRI's skin, > 0 outside; nothing where the skin is beyond
/// the scan or too far.
std::optional<double> gapToSkin_mm(const RigidTransform<Mri, Coil>& mri_T_coil,
                                   const registration::ScalpField& scalp);

class Navigator {
 public:
  /// Starts both trackers. Throws Error when no face is found in the reference frame.
  Navigator(const NavigatorSetup& setup, std::unique_ptr<head_tracking::HeadTracker> head,
            std::unique_ptr<coil_tracking::CoilTracker> coil);

  void setTarget(std::optional<ChosenTarget> target);
  /// Sets the coil that is tracked from the next frame on. Throws Error as CoilTracker::start does, and as
  /// coil_tracking::requireTellable if there is a second coil.
  void setCoil(const coil_tracking::CoilModel& coil);
  /// Tracks a second coil, too, from the next frame on, by its own marker. Throws likewise.
  void addSecondCoil(const coil_tracking::CoilModel& coil,
                     std::unique_ptr<coil_tracking::CoilTracker> tracker);
  /// Sets the second coil's own target; nothing: none.
  void setSecondTarget(std::optional<ChosenTarget> target);
  bool hasSecondCoil() const { return second_.has_value(); }
  /// Replaces the watchdog made from the setup's scalp; null: no watchdog.
  void setWatchdog(std::unique_ptr<monitoring::DriftWatchdog> watchdog) {
    trust_.setWatchdog(std::move(watchdog));
  }
  /// Checks the registration on the next frames; NavigationState::check is the finding. Every pose of the
  /// head is withheld after a failed check until one passes; with `is_withheld_until` from now on. Returns
  /// false without an alignment to a scalp: there is nothing to check.
  bool checkRegistration(bool is_withheld_until = false);
  /// Sets a person's judgement of the alignment. While it is wrong, every pose of the head is withheld. A
  /// check of the registration cannot revoke it, because it compares the face with the alignment itself.
  void judgeAlignment(bool is_wrong) { trust_.judgeAlignment(is_wrong); }
  /// Replaces the check made from the setup's scalp; null: none.
  void setCheck(std::unique_ptr<monitoring::RegistrationCheck> check) { trust_.setCheck(std::move(check)); }
  /// Replaces the measurement of the surface beside the coil; null: none.
  void setGapWatch(std::unique_ptr<monitoring::BesideCoilWatch> watch) { gap_watch_ = std::move(watch); }
  const cameras::StereoRig& rig() const { return rig_; }
  /// What is known of the cameras; before the first frame: from the reference's pictures.
  const health::RigHealth& cameras() const { return trust_.rig(); }
  /// Key frames of the patient's face from this session, to be saved with the case. Empty without an
  /// alignment, or if it is in doubt: judged wrong, a failed check, a drift.
  std::vector<casefile::StoredKeyFrame> learntKeyFrames() const;
  /// Computes poses and guidance of one frame. A frame without images, or of another size than the rig's, is
  /// lost ("camera"), and so is one whose source reports a fault of its cameras (StereoFrame::rig_fault).
  /// After a camera was away, the head is withheld until the registration is checked.
  NavigationState process(std::shared_ptr<const cameras::StereoFrame> frame);

 private:
  struct Second {
    coil_tracking::CoilModel model;
    std::unique_ptr<coil_tracking::CoilTracker> tracker;
    std::shared_ptr<const ChosenTarget> target;  // null: none
    guidance::GuidanceState previous;
    bool was_tracked = false;
  };

  double track(const cameras::StereoFrame& frame, NavigationState& state);
  coil_tracking::CoilResult trackCoils(const cameras::StereoFrame& frame,
                                       const coil_tracking::CoilContext& context, NavigationState& state);
  void place(NavigationState& state) const;
  void judge(const std::shared_ptr<const cameras::StereoFrame>& frame, NavigationState& state);
  void measureGap(const std::shared_ptr<const cameras::StereoFrame>& frame, NavigationState& state);
  void guide(NavigationState& state);
  void guideSecond(NavigationState& state);

  cameras::StereoRig rig_;
  std::optional<RigidTransform<Head, Mri>> head_T_mri_;
  coil_tracking::CoilModel model_;
  std::optional<Second> second_;
  bool is_head_served_, is_coil_served_, was_coil_tracked_ = false;
  guidance::Tolerance tolerance_;
  monitoring::PoseTrust trust_;
  std::shared_ptr<monitoring::DriftCheck> drift_check_;     // null: none
  std::shared_ptr<const registration::ScalpField> scalp_;   // null: no gap
  std::unique_ptr<monitoring::BesideCoilWatch> gap_watch_;  // null: none
  std::unique_ptr<head_tracking::HeadTracker> head_;
  std::unique_ptr<coil_tracking::CoilTracker> coil_;
  FrameWork coil_deferred_;          // work deferred from the last frame to the next one
  bool was_away_ = false;            // true if a camera was away before the newest frame
  bool is_learnt_in_doubt_ = false;  // passed to the head's tracker with the next frame
  /// The chosen target; null: none.
  std::shared_ptr<const ChosenTarget> target_;
  guidance::GuidanceState previous_;
};

}  // namespace facenav::session
