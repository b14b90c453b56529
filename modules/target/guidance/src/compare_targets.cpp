#include "facenav/guidance/compare_targets.h"

#include "facenav/guidance/guidance.h"

namespace facenav::guidance {

TargetDifference compareTargets(const Target& first, const Target& second) {
  const GuidanceValues values = evaluate(first, second.mri_T_target.reframe<Mri, Coil>());
  TargetDifference difference;
  difference.centres_mm = values.distance_mm;
  difference.cortex_mm = (second.cortex_point.mm - first.cortex_point.mm).norm();
  difference.lateral_mm = values.lateral_mm;
  difference.depth_mm = values.depth_mm;
  difference.tilt_rad = values.tilt_rad;
  difference.twist_rad = values.twist_rad;
  return difference;
}

}  // namespace facenav::guidance
