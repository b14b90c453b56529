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
  /// At the moment of the reference frame. Empty: the head is tracked, but not placed in the MRI.
  std::optional<RigidTransform<Camera, Mri>> camera_T_mri_at_reference;
  coil_tracking::CoilModel coil;
  guidance::Tolerance tolerance;
  /// The aligned skin, for the drift watchdog; null: no watchdog.
  std::shared_ptr<const registration::ScalpField> scalp = nullptr;
  /// The coil's contact outline; around it the live surface is measured, while `pace` is live.
  guidance::CoilPlate plate = guidance::figureOfEight();
  /// For work that takes longer than a frame: the drift watchdog, recovery of a lost face.
  head_tracking::Pace pace = head_tracking::Pace::as_live;
  /// The patient's face in earlier sessions; used where the head is placed in the MRI.
  std::vector<casefile::StoredKeyFrame> key_frames = {};
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
  /// Another coil is followed from the next frame on. Throws Error as CoilTracker::start does.
  void setCoil(const coil_tracking::CoilModel& coil);
  /// Replaces the watchdog made from the setup's scalp; null: no watchdog.
  void setWatchdog(std::unique_ptr<monitoring::DriftWatchdog> watchdog) {
    trust_.setWatchdog(std::move(watchdog));
  }
  /// Checks the registration on the next frames; NavigationState::check tells the finding. After a failed
  /// check every pose of the head is withheld until one passes; with `is_withheld_until` already from now on.
  /// False: without an alignment to a scalp there is nothing to check.
  bool checkRegistration(bool is_withheld_until = false);
  /// A person's judgement of the alignment. While it is wrong, every pose of the head is withheld: a check of
  /// the registration cannot lift it, because that compares the face with the alignment itself.
  void judgeAlignment(bool is_wrong) { trust_.judgeAlignment(is_wrong); }
  /// Replaces the check made from the setup's scalp; null: none.
  void setCheck(std::unique_ptr<monitoring::RegistrationCheck> check) { trust_.setCheck(std::move(check)); }
  /// Replaces the measurement of the surface beside the coil; null: none.
  void setGapWatch(std::unique_ptr<monitoring::BesideCoilWatch> watch) { gap_watch_ = std::move(watch); }
  const cameras::StereoRig& rig() const { return rig_; }
  /// Key frames of the patient's face from this session, to be saved with the case; empty without an
  /// alignment, and where that is in doubt: judged wrong, a failed check, a drift.
  std::vector<casefile::StoredKeyFrame> learntKeyFrames() const;
  /// Poses and guidance of one frame. A frame without images, or of another size than the rig's, is lost
  /// ("camera"), and so is one whose source knows a fault of its cameras (StereoFrame::rig_fault). After
  /// cameras were away, the head is withheld until the registration is checked.
  NavigationState process(std::shared_ptr<const cameras::StereoFrame> frame);

 private:
  double track(const cameras::StereoFrame& frame, NavigationState& state);
  void place(NavigationState& state) const;
  void judge(const std::shared_ptr<const cameras::StereoFrame>& frame, NavigationState& state);
  void measureGap(const std::shared_ptr<const cameras::StereoFrame>& frame, NavigationState& state);
  void guide(NavigationState& state);

  cameras::StereoRig rig_;
  std::optional<RigidTransform<Head, Mri>> head_T_mri_;
  RigidTransform<Marker, Coil> marker_T_coil_;
  std::string coil_name_;
  guidance::Tolerance tolerance_;
  monitoring::PoseTrust trust_;
  std::shared_ptr<monitoring::DriftCheck> drift_check_;     // null: none
  std::shared_ptr<const registration::ScalpField> scalp_;   // null: no gap
  std::unique_ptr<monitoring::BesideCoilWatch> gap_watch_;  // null: none
  std::unique_ptr<head_tracking::HeadTracker> head_;
  std::unique_ptr<coil_tracking::CoilTracker> coil_;
  FrameWork coil_deferred_;          // work deferred by the last frame to the next one
  bool was_away_ = false;            // a camera, until the newest frame
  bool is_learnt_in_doubt_ = false;  // passed to the head's tracker with the next frame
  /// Null: none.
  std::shared_ptr<const ChosenTarget> target_;
  guidance::GuidanceState previous_;
};

}  // namespace facenav::session
