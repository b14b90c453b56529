#include "facenav/stimulation/threshold.h"

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/settings_in_force.h"
#include "searches.h"

namespace facenav::stimulation {

std::string toString(ThresholdMethod method) { return method == ThresholdMethod::bayes ? "bayes" : "5of10"; }

ThresholdMethod thresholdMethodFrom(const std::string& word) {
  for (const auto method : {ThresholdMethod::bayes, ThresholdMethod::five_of_ten})
    if (toString(method) == word) return method;
  throw Error("unknown threshold method '" + word + "'", {}, "choose bayes or 5of10");
}

ThresholdState thresholdAfter(ThresholdMethod method, const std::vector<ThresholdAnswer>& answers) {
  const auto& rules = settingsOf<ThresholdRules>();
  for (const auto& answer : answers)
    if (!(answer.intensity_pct >= 0 && answer.intensity_pct <= kFullOutput_pct))
      throw Error(formatted("an intensity of %g %% is not possible", answer.intensity_pct), {},
                  "give 0 to 100 % of the maximal output");
  ThresholdState state =
      method == ThresholdMethod::bayes ? bayesAfter(answers, rules) : fiveOfTenAfter(answers, rules);
  state.pulses = int(answers.size());
  for (const auto& answer : answers) state.responses += answer.has_response;
  return state;
}

std::string inWords(const ThresholdState& state, ThresholdMethod method) {
  std::string words = "not known yet";
  if (state.is_above_output)
    words = "not found up to 100 %";
  else if (state.estimate_pct && method == ThresholdMethod::five_of_ten && !state.isDone())
    words = formatted("%.0f %% or less", *state.estimate_pct);
  else if (state.estimate_pct)
    words = formatted("%.1f %%", *state.estimate_pct);
  if (state.interval_pct && !state.is_above_output)
    words += formatted(" (95 %% interval %.1f to %.1f)", (*state.interval_pct)[0], (*state.interval_pct)[1]);
  return words + ", " + toString(method) +
         formatted(", %d response%s of %d pulse%s", state.responses, state.responses == 1 ? "" : "s",
                   state.pulses, state.pulses == 1 ? "" : "s");
}

}  // namespace facenav::stimulation
