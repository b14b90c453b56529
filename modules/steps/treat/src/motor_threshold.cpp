#include "facenav/treat/motor_threshold.h"

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/stimulation/threshold_rules.h"

namespace facenav::steps {
namespace {

casefile::ThresholdFile fileFor(const ThresholdRequest& request) {
  if (!request.is_new) {
    const auto all = casefile::readThresholds(request.case_folder);
    if (!all.empty()) {
      const auto& last = all.back();
      const bool is_same = last.method == request.method &&
                           (request.muscle.empty() || last.muscle == request.muscle) &&
                           !(request.target && last.target && request.target->name != last.target->name);
      if (is_same && !thresholdAfter(last.method, last.plain()).isDone())
        return casefile::ThresholdFile::open(last.path);
    }
  }
  return casefile::ThresholdFile::begin(request.case_folder, request.method, request.muscle, request.target);
}

}  // namespace

MotorThreshold::MotorThreshold(const ThresholdRequest& request)
    : file_(fileFor(request)),
      state_(thresholdAfter(kept().method, kept().plain())),
      is_resumed_(!kept().answers.empty()) {}

std::string MotorThreshold::inWords() const {
  return stimulation::inWords(state_, kept().method) + (kept().muscle.empty() ? "" : ", " + kept().muscle);
}

void MotorThreshold::keep(const casefile::KeptAnswer& answer) {
  auto answers = kept().plain();
  answers.push_back(answer.answer);
  auto state = thresholdAfter(kept().method, answers);  // throws before anything is written
  file_.keep(answer);
  state_ = std::move(state);
}

void MotorThreshold::answer(double intensity_pct, bool has_response) {
  keep({{intensity_pct, has_response}});
}

void MotorThreshold::answerWithMep(double intensity_pct, double mep_uv) {
  if (!(mep_uv >= 0) || !std::isfinite(mep_uv))
    throw Error(formatted("an MEP of %g uV is not possible", mep_uv), {},
                "give its peak-to-peak amplitude in uV, 0 or more");
  const double response_uv = settingsOf<stimulation::ThresholdRules>().response_uv;
  keep({{intensity_pct, mep_uv >= response_uv}, mep_uv});
}

void MotorThreshold::takeBack() {
  file_.takeBack();
  state_ = thresholdAfter(kept().method, kept().plain());
}

std::vector<stimulation::ThresholdAnswer> thresholdAnswers(const casefile::SessionPulses& session,
                                                           const std::map<int, bool>& twitches) {
  const double response_uv = settingsOf<stimulation::ThresholdRules>().response_uv;
  std::vector<stimulation::ThresholdAnswer> answers;
  for (const auto& reviewed : session.pulses) {
    const auto& pulse = reviewed.pulse;
    if (reviewed.is_excluded || !pulse.intensity_pct) continue;
    const auto twitch = twitches.find(pulse.number);
    if (pulse.mep_uv)
      answers.push_back({*pulse.intensity_pct, *pulse.mep_uv >= response_uv});
    else if (twitch != twitches.end())
      answers.push_back({*pulse.intensity_pct, twitch->second});
  }
  return answers;
}

}  // namespace facenav::steps
