#include "facenav/monitoring/pose_trust.h"

namespace facenav::monitoring {
namespace {

using Reason = Withheld::Reason;
using Source = Withheld::Source;

}  // namespace

bool PoseTrust::checkRegistration(bool is_withheld_until) {
  if (!check_) return false;
  check_->begin();
  if (is_withheld_until) by_check_ = Withheld{Reason::not_checked, Source::registration_check};
  return true;
}

void PoseTrust::addCameras(const cameras::StereoFrame& frame, const Tracked<head_tracking::HeadPose>& head,
                           const coil_tracking::CoilResult& coil) {
  rig_.add(observer_.observe(frame, head, coil));
}

void PoseTrust::addFace(const std::shared_ptr<const cameras::StereoFrame>& frame,
                        const Tracked<head_tracking::HeadPose>& head,
                        const std::optional<RigidTransform<Camera, Mri>>& camera_T_mri) {
  if (check_) {
    check_->add(frame, camera_T_mri);
    if (const auto finding = check_->take()) takeFinding(*finding);
  }
  if (!watchdog_) return;
  const bool was_alarmed = watchdog_->isAlarmed();
  if (!head || head->between_exposures_mm < kMostBetweenExposures_mm) watchdog_->add(frame, camera_T_mri);
  has_new_alarm_ = watchdog_->isAlarmed() && !was_alarmed;
}

void PoseTrust::takeFinding(const RegistrationFinding& finding) {
  using Verdict = DriftFinding::Verdict;
  if (finding.verdict == Verdict::agrees) by_check_.reset();
  if (finding.verdict == Verdict::drifted)
    by_check_ = Withheld{
        Reason::registration_failed, Source::registration_check, {}, finding.shift_mm, finding.turn_deg};
  const bool must_repeat =
      finding.verdict == Verdict::unknown && by_check_ && by_check_->reason == Reason::not_checked;
  if (must_repeat) check_->begin();
  if (!must_repeat || !finding_) finding_ = std::make_shared<const RegistrationFinding>(finding);
}

std::optional<Withheld> PoseTrust::withheld(const cameras::StereoFrame& frame) const {
  if (!frame.rig_fault.empty())
    return Withheld{Reason::camera_fault, Source::cameras, {health::RigState::moved, frame.rig_fault, {}}};
  if (const auto fault = rig_.fault()) return Withheld{Reason::camera_fault, Source::cameras, *fault};
  if (isAlarmed()) return Withheld{Reason::drifted, Source::drift};
  if (is_judged_wrong_) return Withheld{Reason::judged_wrong, Source::person};
  return by_check_;
}

bool PoseTrust::isAlignmentInDoubt() const { return is_judged_wrong_ || by_check_ || isAlarmed(); }

std::optional<Withheld> withheldByAbsence(const cameras::StereoFrame& frame) {
  if (frame.absence.empty()) return std::nullopt;
  return Withheld{
      Withheld::Reason::camera_fault, Withheld::Source::cameras, {health::RigState::away, frame.absence, {}}};
}

}  // namespace facenav::monitoring
