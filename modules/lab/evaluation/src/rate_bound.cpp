#include "facenav/evaluation/rate_bound.h"

#include <cmath>

namespace facenav::evaluation {
namespace {

/// Probability of at most `events` in `trials` at this rate, strictly between 0 and 1.
double atMost(int events, int trials, double rate) {
  double sum = 0.0;
  for (int k = 0; k <= events; ++k)
    sum += std::exp(std::lgamma(trials + 1.0) - std::lgamma(k + 1.0) - std::lgamma(trials - k + 1.0) +
                    k * std::log(rate) + (trials - k) * std::log1p(-rate));
  return sum;
}

}  // namespace

double rateBound95(int events, int trials) {
  constexpr double kBeyond = 0.05;
  constexpr int kHalvings = 50;
  if (events >= trials) return 1.0;
  double low = 0.0, high = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (atMost(events, trials, middle) > kBeyond ? low : high) = middle;
  }
  return high;
}

}  // namespace facenav::evaluation
