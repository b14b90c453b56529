#pragma once
// The differences between two targets.

#include "facenav/guidance/target.h"

namespace facenav::guidance {

struct TargetDifference {
  double centres_mm = 0;                // straight-line distance of the coil's centres
  double cortex_mm = 0;                 // distance of the cortex points
  double lateral_mm = 0, depth_mm = 0;  // offset of the second's centre, across and along the first's z
  double tilt_rad = 0, twist_rad = 0;   // as in guidance.csv
};
/// Differences of the second target relative to the first.
TargetDifference compareTargets(const Target& first, const Target& second);

}  // namespace facenav::guidance
