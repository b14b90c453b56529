#include "report_protocol.h"

#include <algorithm>
#include <cmath>

#include "facenav/casefile/protocol.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"
#include "report_html.h"

namespace facenav::report {
namespace {

constexpr const char* kNotStated = "not stated";
constexpr const char* kNothingRecorded = "not recorded";
constexpr double kTrainPause_s = 1.5;  // without a plan, a longer pause begins another train
// Tolerances for equal frequency and intensity: stimulators are set in 0.1 Hz and whole %.
constexpr double kSameFrequency = 0.05, kSameOutput_pct = 1.0;

std::optional<casefile::Protocol> planOf(const casefile::CaseStore& store,
                                         const casefile::KeptSession& session) {
  const auto kept = session.folder / "protocol.json";
  if (std::filesystem::exists(kept)) return casefile::readProtocol(kept);
  return casefile::protocolOf(store.folder());
}

/// Rhythm given, from the times of the pulses that are not excluded. A train has two pulses or more.
struct Rhythm {
  int pulses = 0, trains = 0, in_trains = 0, on_target = 0;
  std::optional<double> frequency_hz, pause_s;  // medians
  std::vector<double> outputs_pct;
  int single() const { return pulses - in_trains; }
};

/// Threshold between the step within a train and the pause after it.
double trainPause_s(const std::optional<casefile::Protocol>& plan) {
  if (!plan || !(plan->dose.frequency_hz > 0) || plan->dose.trains < 2) return kTrainPause_s;
  return 0.5 * (1.0 / plan->dose.frequency_hz + plan->dose.pause_s);
}

/// The pulse's time by the machine's steady clock, by which the pulses were given. A recording's own clock
/// (t_s) stands still while the recording is played slowly. Nothing: not known.
std::optional<double> timeOf(const casefile::Pulse& pulse) {
  return pulse.steady_s > 0 ? std::optional(pulse.steady_s) : pulse.t_s;
}

/// Adds trains and the times between pulses. `times_s`: of all pulses, in order.
void addTrains(const std::vector<double>& times_s, double train_pause_s, Rhythm& rhythm) {
  std::vector<double> steps_s, pauses_s;
  std::size_t first = 0;               // of the present group
  std::optional<double> last_train_s;  // end of the last train
  for (std::size_t i = 1; i <= times_s.size(); ++i) {
    const double step_s = i < times_s.size() ? times_s[i] - times_s[i - 1] : -1;
    if (step_s >= 0 && step_s <= train_pause_s) {  // < 0: the machine was started anew
      steps_s.push_back(step_s);
      continue;
    }
    if (i - first >= 2) {
      ++rhythm.trains;
      rhythm.in_trains += int(i - first);
      if (last_train_s && times_s[first] > *last_train_s) pauses_s.push_back(times_s[first] - *last_train_s);
      last_train_s = times_s[i - 1];
    }
    first = i;
  }
  if (!steps_s.empty() && median(steps_s) > 0) rhythm.frequency_hz = 1.0 / median(steps_s);
  if (!pauses_s.empty()) rhythm.pause_s = median(pauses_s);
}

Rhythm rhythmOf(const casefile::KeptSession& session, double train_pause_s) {
  Rhythm rhythm;
  std::vector<double> times_s;
  for (const auto& reviewed : session.pulses.pulses) {
    if (reviewed.is_excluded) continue;
    ++rhythm.pulses;
    rhythm.on_target += reviewed.pulse.status == casefile::PulseStatus::on_target;
    if (reviewed.pulse.intensity_pct) rhythm.outputs_pct.push_back(*reviewed.pulse.intensity_pct);
    if (const auto time_s = timeOf(reviewed.pulse)) times_s.push_back(*time_s);
  }
  addTrains(times_s, train_pause_s, rhythm);
  return rhythm;
}

std::string numberWords(const std::optional<double>& value, const char* form, const char* otherwise) {
  return value ? formatted(form, *value) : std::string(otherwise);
}

std::string outputWords(const Rhythm& given) {
  if (given.outputs_pct.empty()) return kNothingRecorded;
  const auto [low, high] = std::minmax_element(given.outputs_pct.begin(), given.outputs_pct.end());
  return formatted("%.1f %% (%.1f to %.1f), stated for %zu pulses", median(given.outputs_pct), *low, *high,
                   given.outputs_pct.size());
}

std::string plannedFrequency(const guidance::Dose& plan) {
  return plan.frequency_hz > 0 ? formatted("%.1f Hz", plan.frequency_hz) : std::string("no fixed rate");
}

std::string countWords(const guidance::Dose& plan, const Rhythm& given) {
  std::string words = formatted("%d of %d planned pulses were given", given.pulses, plan.pulses);
  if (given.pulses < plan.pulses) words += formatted(": %d are missing", plan.pulses - given.pulses);
  if (given.pulses > plan.pulses) words += formatted(": %d too many", given.pulses - plan.pulses);
  return words + formatted(". %d of them were on target.", given.on_target);
}

/// Describes the other differences from the plan.
std::string differenceWords(const guidance::Dose& plan, const Rhythm& given) {
  std::string words;
  const auto add = [&](const std::string& what) { words += (words.empty() ? "" : "; ") + what; };
  if (given.trains != plan.trains && plan.frequency_hz > 0)
    add(formatted("%d trains in place of %d", given.trains, plan.trains));
  if (plan.frequency_hz > 0 && given.frequency_hz &&
      std::abs(*given.frequency_hz - plan.frequency_hz) > kSameFrequency * plan.frequency_hz)
    add(formatted("%.1f Hz in place of %.1f", *given.frequency_hz, plan.frequency_hz));
  if (plan.output_pct && !given.outputs_pct.empty() &&
      std::abs(median(given.outputs_pct) - *plan.output_pct) > kSameOutput_pct)
    add(formatted("%.1f %% of the output in place of %.1f", median(given.outputs_pct), *plan.output_pct));
  return words.empty() ? "Rhythm and intensity were as planned." : "Not as planned: " + words + ".";
}

std::string comparison(const casefile::Protocol& plan, const Rhythm& given) {
  const auto& dose = plan.dose;
  std::vector<TableRow> rows{
      {"Pulses", formatted("%d", dose.pulses), formatted("%d of %d", given.pulses, dose.pulses)},
      {"Trains", formatted("%d", dose.trains), formatted("%d of %d", given.trains, dose.trains)},
      {"Frequency in a train", plannedFrequency(dose),
       numberWords(given.frequency_hz, "%.1f Hz (median)", kNothingRecorded)},
      {"Pause between trains", formatted("%.1f s", dose.pause_s),
       numberWords(given.pause_s, "%.1f s (median)", "none")},
      {"Intensity, of maximal output", numberWords(dose.output_pct, "%.1f %%", kNotStated),
       outputWords(given)}};
  if (dose.threshold_pct)
    rows.push_back(
        {"Intensity, of the motor threshold", formatted("%.0f %%", *dose.threshold_pct), kNothingRecorded});
  return headingHtml("Protocol against given") +
         paragraphHtml(plan.name + formatted(", version %d. ", plan.version) + countWords(dose, given) + " " +
                       differenceWords(dose, given)) +
         tableHtml({"", "planned", "given"}, rows);
}

}  // namespace

std::string trainWords(const casefile::CaseStore& store, const casefile::KeptSession& session) {
  std::optional<casefile::Protocol> plan;
  try {
    plan = planOf(store, session);
  } catch (const Error&) {  // protocolPart reports it
  }
  const Rhythm given = rhythmOf(session, trainPause_s(plan));
  if (given.pulses == 0) return kNothingRecorded;
  const std::string single =
      formatted("%d single %s", given.single(), given.single() == 1 ? "pulse" : "pulses");
  if (given.trains == 0 || !given.frequency_hz) return single;
  std::string words = formatted("%d %s, %.1f pulses each on average, %.1f Hz", given.trains,
                                given.trains == 1 ? "train" : "trains",
                                double(given.in_trains) / given.trains, *given.frequency_hz);
  if (given.pause_s) words += formatted(", pauses of %.1f s (medians)", *given.pause_s);
  return words + (given.single() > 0 ? "; " + single : "");
}

std::string protocolPart(const casefile::CaseStore& store, const casefile::KeptSession& session) {
  try {
    const auto plan = planOf(store, session);
    return plan ? comparison(*plan, rhythmOf(session, trainPause_s(plan))) : std::string();
  } catch (const Error&) {
    return headingHtml("Protocol against given") + paragraphHtml("The protocol's file cannot be read.");
  }
}

}  // namespace facenav::report
