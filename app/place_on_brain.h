#pragma once
// Where a place named by the atlas or typed by hand is aimed at.

#include "facenav/casefile/case_store.h"
#include "facenav/surface/closest_point.h"

namespace facenav::app {

/// `p` (Mri, mm) itself inside the brain model or where the case has none; else the nearest point of the
/// model.
inline Point<Mri> onBrain(const casefile::CaseStore& store, const Point<Mri>& p) {
  const auto brain = store.brain();
  if (!brain) return p;
  const auto nearest = surface::ClosestPoint(brain->mesh).nearest(p);
  return nearest.is_outside ? nearest.point : p;
}

}  // namespace facenav::app
