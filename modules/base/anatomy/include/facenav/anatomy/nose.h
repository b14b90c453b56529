#pragma once
// Finds the nose on the skin. Three searches use the same two measures: how far the skin stands out from the
// cheeks beside it, and how far forward it lies.
// - findNoseRise: is there a nose at all? For every scan, also a defaced one; so it needs the rise from the
//   nose's root.
// - findNoseTip: about where is its tip? It always returns a place, also when the scan cuts the nose, because
//   starts and regions need a place exact to a centimetre. Stored in scalp_field.bin, so its result must not
//   change.
// - midlineLandmarks (midline_profile.h): where exactly is it, by the anthropometric definition? Only on a
//   whole nose.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "facenav/anatomy/front_relief.h"

namespace facenav::anatomy {

/// Height of the midline above both sides, 30 mm away, mm; FrontRelief::kNone if unknown.
double prominence_mm(const FrontRelief& relief, int midline, int row);
/// Mean Mri y of both sides at `beside_mm` from the midline; FrontRelief::kNone where one has no skin.
double sides_mm(const FrontRelief& relief, int midline, int row, double beside_mm);

struct NoseRise {
  int root_row = 0;    // flattest row above the crest: the nose's root, or the forehead above it
  int crest_row = 0;   // where it stands out most
  double rise_mm = 0;  // difference between the prominence there and that of the forehead
};
/// The strongest rise of the prominence within a nose's length, below the forehead. `relief`: rows from the
/// top.
std::optional<NoseRise> findNoseRise(const FrontRelief& relief, int midline);

/// The tip of the nose, or of its part inside the scan, Mri mm: where the front of the head stands out most
/// from the skin 25-35 mm to both sides. Independent of the head's pitch. `skin_mm`: at least one point, Mri.
Eigen::Vector3d findNoseTip(const std::vector<Eigen::Vector3d>& skin_mm);

}  // namespace facenav::anatomy
