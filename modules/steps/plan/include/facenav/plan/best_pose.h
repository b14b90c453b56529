#pragma once
// The coil's best pose for a target: handle angle and place on the scalp that give the strongest field at the
// target, or along the normal of its cortex.

#include "facenav/plan/cortex_field.h"
#include "facenav/plan/plan_edits.h"

namespace facenav::steps {

enum class FieldAim {
  strength,     // |E| at the target
  along_normal  // |E| along the cortex' normal, across the sulcus
};

struct BestPose {
  guidance::Target target;       ///< the planned one with its plate at the best pose; nothing is stored
  double x_mm = 0, y_mm = 0;     ///< from the planned plate's centre to the best one's, in the planned axes
  double turned_deg = 0;         ///< > 0 clockwise when seen along the coil's z
  double planned = 0, best = 0;  ///< what was maximised, V/m at 1 A/us
  int poses = 0;                 ///< that were tried
};

/// Tries 36 handle angles at each place of a grid of 2 x 2 cm round the planned one, with the planned gap and
/// the plate resting on the scalp. Of angles that are equal within 0.01 %, the one nearest to the planned
/// wins.
BestPose bestPose(const HeadField& head, const FieldSurfaces& surfaces, const PlannedHead& planned,
                  const efield::CoilDipoles& coil, const guidance::Target& target, FieldAim aim);

}  // namespace facenav::steps
