#pragma once
// PoseTrust: decides whether the poses of this frame may be shown. It combines the state of the cameras
// (health/), drift, the registration check and a person's judgement into one answer for head and coil. The
// navigator asks once a frame.

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

  /// Sets the pair that tracking starts from.
  void start(const head_tracking::HeadReference& reference) {
    rig_.start(reference.frame, reference.surface, reference.surface_left_px, reference.face_px);
  }
  /// Sets the watchdog; null: no check.
  void setWatchdog(std::unique_ptr<DriftWatchdog> watchdog) { watchdog_ = std::move(watchdog); }
  void setCheck(std::unique_ptr<RegistrationCheck> check) { check_ = std::move(check); }

  /// Checks the registration on the next frames. Returns false if there is nothing to check. The head is
  /// withheld after a failed check until one passes; with `is_withheld_until` from now on.
  bool checkRegistration(bool is_withheld_until);
  /// Sets a person's judgement. A check cannot revoke it, because it compares the face with the alignment
  /// itself.
  void judgeAlignment(bool is_wrong) { is_judged_wrong_ = is_wrong; }

  /// Adds the trackers' measurements of the cameras in this frame.
  void addCameras(const cameras::StereoFrame& frame, const Tracked<head_tracking::HeadPose>& head,
                  const coil_tracking::CoilResult& coil);
  /// Adds the frame and its tracked head pose, shown or not; without a pose where the head is lost. Slow work
  /// runs in parallel.
  void addFace(const std::shared_ptr<const cameras::StereoFrame>& frame,
               const Tracked<head_tracking::HeadPose>& head,
               const std::optional<RigidTransform<Camera, Mri>>& camera_T_mri);
  /// Reason why the poses of the last added frame are withheld; empty: they may be shown.
  std::optional<Withheld> withheld(const cameras::StereoFrame& frame) const;

  const health::RigHealth& rig() const { return rig_; }
  /// Newest finding of a check; null: none was made.
  const std::shared_ptr<const RegistrationFinding>& finding() const { return finding_; }
  bool hasWatchdog() const { return watchdog_ != nullptr; }
  /// True if the watchdog's alarm began with the last added frame.
  bool hasNewAlarm() const { return has_new_alarm_; }
  /// True if key frames learnt in this session may refer to a wrong place of the MRI.
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

/// Reason to withhold the poses of a frame without pictures; empty if its source gives none.
std::optional<Withheld> withheldByAbsence(const cameras::StereoFrame& frame);

}  // namespace facenav::monitoring
