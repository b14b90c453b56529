#pragma once
// PoseTrust: may the poses of this frame be shown? It gathers what is known of the cameras (health/), of
// drift, of the registration and of a person's judgement, and gives one answer for head and coil together.
// The navigator asks once a frame.

#include <memory>
#include <optional>

#include "facenav/health/rig_health.h"
#include "facenav/monitoring/drift_watchdog.h"
#include "facenav/monitoring/registration_check.h"
#include "facenav/monitoring/rig_observer.h"
#include "facenav/monitoring/withheld.h"

namespace facenav::monitoring {

class PoseTrust {
 public:
  explicit PoseTrust(const cameras::StereoRig& rig) : rig_(rig) {}

  /// The pair that tracking starts from.
  void start(const head_tracking::HeadReference& reference) {
    rig_.start(reference.frame, reference.surface, reference.surface_left_px);
  }
  /// Null: no watchdog, no check.
  void setWatchdog(std::unique_ptr<DriftWatchdog> watchdog) { watchdog_ = std::move(watchdog); }
  void setCheck(std::unique_ptr<RegistrationCheck> check) { check_ = std::move(check); }

  /// Checks the registration on the next frames. False: there is nothing to check. After a failed check the
  /// head is withheld until one passes; with `is_withheld_until` already from now on.
  bool checkRegistration(bool is_withheld_until);
  /// A check cannot lift this judgement: it compares the face with the alignment itself.
  void judgeAlignment(bool is_wrong) { is_judged_wrong_ = is_wrong; }

  /// What the trackers measured of the cameras in this frame.
  void addCameras(const cameras::StereoFrame& frame, const Tracked<head_tracking::HeadPose>& head,
                  const coil_tracking::CoilResult& coil);
  /// The face and where it is tracked, shown or not; without a pose where the head is lost. Slow work is done
  /// beside the frames.
  void addFace(const std::shared_ptr<const cameras::StereoFrame>& frame,
               const Tracked<head_tracking::HeadPose>& head,
               const std::optional<RigidTransform<Camera, Mri>>& camera_T_mri);
  /// As of the frame that was added last. Empty: the poses may be shown.
  std::optional<Withheld> withheld(const cameras::StereoFrame& frame) const;

  const health::RigHealth& rig() const { return rig_; }
  /// The newest finding of a check; null: none was made.
  const std::shared_ptr<const RegistrationFinding>& finding() const { return finding_; }
  bool hasWatchdog() const { return watchdog_ != nullptr; }
  /// The watchdog's alarm began with the frame that was added last.
  bool hasNewAlarm() const { return has_new_alarm_; }
  /// What was learnt of the face may belong to a wrong place of the MRI.
  bool isAlignmentInDoubt() const;

 private:
  void takeFinding(const RegistrationFinding& finding);
  bool isAlarmed() const { return watchdog_ && watchdog_->isAlarmed(); }

  health::RigHealth rig_;
  RigObserver observer_;
  std::unique_ptr<DriftWatchdog> watchdog_;
  std::unique_ptr<RegistrationCheck> check_;
  std::shared_ptr<const RegistrationFinding> finding_;
  std::optional<Withheld> by_check_;  // not checked, or failed
  bool is_judged_wrong_ = false, has_new_alarm_ = false;
};

/// What withholds the poses of a frame without pictures; empty: its source does not say why there are none.
std::optional<Withheld> withheldByAbsence(const cameras::StereoFrame& frame);

}  // namespace facenav::monitoring
