#include "facenav/monitoring/drift_watchdog.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"

namespace facenav::monitoring {

DriftWatchdog::Checks::Work DriftWatchdog::workOf(Measure measure) {
  FACENAV_EXPECT(bool(measure), "something must measure");
  return [measure = std::move(measure)](const Question& question) {
    return Answer{question.frame->captured.s, measure(*question.frame, question.camera_T_mri)};
  };
}

DriftWatchdog::DriftWatchdog(Measure measure, Mode mode) : checks_(workOf(std::move(measure)), mode) {}

bool DriftWatchdog::isDue(double captured_s) const {
  if (checks_.isBusy()) return false;
  if (!asked_s_) return true;
  const double waited_s = std::abs(captured_s - *asked_s_);  // a recording may restart
  return waited_s >= (was_lost_ ? kRecheck_s : interval_s_);
}

void DriftWatchdog::take(const Answer& answer) {
  finding_ = answer.finding;
  using Verdict = DriftFinding::Verdict;
  if (finding_.verdict == Verdict::drifted) ++drifted_in_row_;
  if (finding_.verdict == Verdict::agrees) drifted_in_row_ = 0, is_alarmed_ = false;
  if (drifted_in_row_ >= kLeastAgreeing) is_alarmed_ = true;
  interval_s_ = drifted_in_row_ > 0 || is_alarmed_ ? kRecheck_s : kInterval_s;
}

void DriftWatchdog::add(std::shared_ptr<const cameras::StereoFrame> frame,
                        const std::optional<RigidTransform<Camera, Mri>>& camera_T_mri) {
  FACENAV_EXPECT(frame != nullptr, "a frame is needed");
  const double now_s = frame->captured.s;
  if (const auto answer = checks_.take(now_s)) take(*answer);
  if (!camera_T_mri) {
    was_lost_ = true;
    return;
  }
  if (!isDue(now_s)) return;
  was_lost_ = false, asked_s_ = now_s;
  checks_.ask(std::make_shared<Question>(Question{std::move(frame), *camera_T_mri}), now_s);
}

}  // namespace facenav::monitoring
