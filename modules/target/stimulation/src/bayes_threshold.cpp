#include <algorithm>
#include <cmath>

#include "normal_curve.h"
#include "searches.h"

namespace facenav::stimulation {
namespace {

// The grid goes above 100 %: thresholds above the stimulator's output exist and must not be forced below it.
constexpr double kLowestCell_pct = 1, kHighestCell_pct = 150, kStep_pct = 0.25;
constexpr double kLeastProbability = 1e-12;  // one answer alone never excludes a threshold for good
constexpr double kTail = 0.025;

double thresholdAt(std::size_t cell) { return kLowestCell_pct + double(cell) * kStep_pct; }

/// Probabilities of the grid's thresholds; their sum is 1.
std::vector<double> posterior(const std::vector<ThresholdAnswer>& answers, const ThresholdRules& rules) {
  std::vector<double> logs(std::size_t(std::lround((kHighestCell_pct - kLowestCell_pct) / kStep_pct)) + 1);
  for (std::size_t cell = 0; cell < logs.size(); ++cell) {
    const double threshold = thresholdAt(cell), spread = rules.spread_share * threshold;
    const double z = (threshold - rules.prior_mean_pct) / rules.prior_spread_pct;
    logs[cell] = -0.5 * z * z;
    for (const auto& answer : answers) {
      const double p = normalBelow((answer.intensity_pct - threshold) / spread);
      logs[cell] += std::log(std::max(kLeastProbability, answer.has_response ? p : 1.0 - p));
    }
  }
  const double most = *std::max_element(logs.begin(), logs.end());
  double sum = 0;
  for (double& value : logs) sum += value = std::exp(value - most);
  for (double& value : logs) value /= sum;
  return logs;
}

double meanOf(const std::vector<double>& probabilities) {
  double mean = 0;
  for (std::size_t cell = 0; cell < probabilities.size(); ++cell)
    mean += probabilities[cell] * thresholdAt(cell);
  return mean;
}

double quantileOf(const std::vector<double>& probabilities, double share) {
  double sum = 0;
  for (std::size_t cell = 0; cell < probabilities.size(); ++cell) {
    const double before = sum;
    sum += probabilities[cell];
    if (sum >= share)  // a cell's probability is spread evenly over its width
      return thresholdAt(cell) + kStep_pct * ((share - before) / probabilities[cell] - 0.5);
  }
  return kHighestCell_pct;
}

/// Widens the 95 % interval about the median. The posterior is too narrow: it assumes a known spread of the
/// response curve, but that differs between people.
std::array<double, 2> widened(const std::vector<double>& probabilities, double factor) {
  const double middle = quantileOf(probabilities, 0.5);
  return {std::max(0.0, middle + factor * (quantileOf(probabilities, kTail) - middle)),
          middle + factor * (quantileOf(probabilities, 1 - kTail) - middle)};
}

}  // namespace

ThresholdState bayesAfter(const std::vector<ThresholdAnswer>& answers, const ThresholdRules& rules) {
  const auto probabilities = posterior(answers, rules);
  ThresholdState state;
  const double mean = meanOf(probabilities);
  state.estimate_pct = mean;
  state.interval_pct = widened(probabilities, rules.interval_widening);
  const double width = (*state.interval_pct)[1] - (*state.interval_pct)[0];
  const bool is_done = int(answers.size()) >= rules.most_pulses || width <= rules.stop_width_pct;
  if (!is_done) state.next_pct = std::clamp(std::round(mean), 1.0, kFullOutput_pct);
  state.is_above_output = is_done && mean > kFullOutput_pct;
  return state;
}

}  // namespace facenav::stimulation
