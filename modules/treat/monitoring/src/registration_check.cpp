#include "facenav/monitoring/registration_check.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/core/settings_in_force.h"

namespace facenav::monitoring {
namespace {

DriftWatchdog::Checks::Work measuring(DriftWatchdog::Measure measure) {
  FACENAV_EXPECT(bool(measure), "something must measure");
  return [measure = std::move(measure)](const DriftWatchdog::Question& question) {
    return DriftWatchdog::Answer{question.frame->captured.s, measure(*question.frame, question.camera_T_mri)};
  };
}

}  // namespace

std::string inWords(const RegistrationFinding& finding) {
  using Verdict = DriftFinding::Verdict;
  if (finding.verdict == Verdict::unknown)
    return formatted("not possible: too little of the face was measured (%d measurement%s)",
                     finding.measurements, finding.measurements == 1 ? "" : "s");
  return (finding.hasPassed() ? "passed" : "failed") +
         formatted(": face %.1f mm and %.1f deg from where the MRI's is, %d measurements", finding.shift_mm,
                   finding.turn_deg, finding.measurements);
}

RegistrationFinding findingOf(const std::vector<DriftFinding>& measurements) {
  using Verdict = DriftFinding::Verdict;
  RegistrationFinding finding;
  std::vector<double> shift_mm, turn_deg;
  int agreeing = 0, drifted = 0;
  for (const auto& one : measurements) {
    if (one.verdict == Verdict::unknown) continue;
    ++(one.verdict == Verdict::agrees ? agreeing : drifted);
    shift_mm.push_back(one.shift_mm);
    turn_deg.push_back(one.turn_deg);
  }
  finding.measurements = agreeing + drifted;
  if (finding.measurements == 0) return finding;
  finding.shift_mm = median(shift_mm);
  finding.turn_deg = median(turn_deg);
  if (agreeing >= kLeastAgreeing && agreeing > drifted) finding.verdict = Verdict::agrees;
  if (drifted >= kLeastAgreeing && drifted >= agreeing) finding.verdict = Verdict::drifted;
  return finding;
}

RegistrationCheck::RegistrationCheck(DriftWatchdog::Measure measure, DriftWatchdog::Mode mode)
    : checks_(measuring(std::move(measure)), mode) {}

void RegistrationCheck::begin() {
  is_running_ = true;
  begun_s_.reset();
  asked_s_.reset();
  measured_.clear();
}

void RegistrationCheck::add(std::shared_ptr<const cameras::StereoFrame> frame,
                            const std::optional<RigidTransform<Camera, Mri>>& camera_T_mri) {
  FACENAV_EXPECT(frame != nullptr, "a frame is needed");
  const double now_s = frame->captured.s;
  // Ignores the result of a measurement requested by the previous check.
  if (const auto answer = checks_.take(now_s); answer && begun_s_ && answer->captured_s >= *begun_s_)
    measured_.push_back(answer->finding);
  if (!is_running_) return;
  if (!begun_s_ || now_s < *begun_s_) begun_s_ = now_s;
  const auto known = std::count_if(measured_.begin(), measured_.end(), [](const DriftFinding& one) {
    return one.verdict != DriftFinding::Verdict::unknown;
  });
  if (std::size_t(known) >= kEnough || now_s - *begun_s_ >= settingsOf<RegistrationCheckRules>().check_s) {
    is_running_ = false;
    done_ = findingOf(measured_);
    done_->number = ++number_;
    return;
  }
  if (!camera_T_mri || checks_.isBusy() ||
      (asked_s_ && std::abs(now_s - *asked_s_) < DriftWatchdog::kRecheck_s))
    return;
  asked_s_ = now_s;
  checks_.ask(
      std::make_shared<DriftWatchdog::Question>(DriftWatchdog::Question{std::move(frame), *camera_T_mri}),
      now_s);
}

std::optional<RegistrationFinding> RegistrationCheck::take() { return std::exchange(done_, std::nullopt); }

}  // namespace facenav::monitoring
