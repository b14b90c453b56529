#include "patch_weights.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/robust_statistics.h"

namespace facenav::head_tracking {
namespace {

constexpr double kMemory_s = 0.7;   // time constant to notice that a patch moves by itself
constexpr double kExpected = 4.0;   // squared distance that noise explains
constexpr double kLongest_s = 0.1;  // longest time between two frames that is weighted

}  // namespace

std::vector<float> PatchWeights::weights() const {
  std::vector<float> factors;
  for (const double wander : wander_) factors.push_back(float(1.0 / (1.0 + wander / kExpected)));
  return factors;
}

void PatchWeights::learn(const PoseFit& fit, double since_s) {
  const double share = 1.0 - std::exp(-std::clamp(since_s, 0.0, kLongest_s) / kMemory_s);
  for (std::size_t i = 0; i < wander_.size(); ++i) {
    double seen = -1.0;
    for (const auto& measurement : fit.measurements[i])
      if (measurement.is_visible)
        // A patch beyond the fit's reach has no weight there; how far it is then says nothing.
        seen = std::max(seen, std::pow(std::min(double(measurement.distance), kTukeyReach), 2));
    if (seen >= 0) wander_[i] += share * (std::max(0.0, seen - kExpected) - wander_[i]);
  }
}

}  // namespace facenav::head_tracking
