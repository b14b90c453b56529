#pragma once
// How two targets differ.

#include "facenav/guidance/target.h"

namespace facenav::guidance {

struct TargetDifference {
  double centres_mm = 0;                // between the coil's centres, in a straight line
  double cortex_mm = 0;                 // between the cortex points
  double lateral_mm = 0, depth_mm = 0;  // of the second's centre, across and along the first's z
  double tilt_rad = 0, twist_rad = 0;   // as guidance.csv has them
};
/// The second as seen from the first.
TargetDifference compareTargets(const Target& first, const Target& second);

}  // namespace facenav::guidance
