#pragma once
// PatchWeights: skin that keeps moving relative to the rigid fit (lips, jaw, lids) loses weight.

#include <vector>

#include "pose_fit.h"

namespace facenav::head_tracking {

class PatchWeights {
 public:
  PatchWeights() = default;
  explicit PatchWeights(std::size_t patches) : wander_(patches, 0.0) {}

  /// Weight in (0, 1] of each patch of the finest level.
  std::vector<float> weights() const;
  /// Adds a tracked frame, `since_s` after the previous one.
  void learn(const PoseFit& fit, double since_s);
  void forget() { wander_.assign(wander_.size(), 0.0); }

 private:
  std::vector<double> wander_;  // mean squared distance beyond the expected one
};

}  // namespace facenav::head_tracking
