#pragma once
// Where a place named by the atlas or typed by hand is aimed at.

#include <cmath>

#include "facenav/casefile/case_store.h"
#include "facenav/core/error.h"
#include "facenav/surface/closest_point.h"
#include "facenav/surface/outside_head.h"

namespace facenav::workflow {

/// `p` (Mri, mm) itself inside the brain model or where the case has none; else the nearest point of the
/// model. Throws Error for a place more than surface::kFarthestOutside_mm outside the head.
inline Point<Mri> onBrain(const casefile::CaseStore& store, const Point<Mri>& p) {
  const double outside_mm = surface::outsideHead_mm(store.headMask(), store.scalp(), p);
  if (outside_mm > surface::kFarthestOutside_mm)
    throw Error("the place lies " + std::to_string(std::lround(outside_mm)) + " mm outside the head", {},
                "check the numbers, and whether they are MNI or RAS");
  const auto brain = store.brain();
  if (!brain) return p;
  const auto nearest = surface::ClosestPoint(brain->mesh).nearest(p);
  return nearest.is_outside ? nearest.point : p;
}

}  // namespace facenav::workflow
