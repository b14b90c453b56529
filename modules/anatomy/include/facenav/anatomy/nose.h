#pragma once
// The nose, found on the skin. Three questions, each with its own search over the same two measures (how far
// the skin stands out from the cheeks beside it, how far forward it lies):
//   findNoseRise     is there a nose at all? Asked of every scan, defaced ones too, so it needs the rise from
//   the root. findNoseTip      about where is its tip? Always answers, also where the scan cuts the nose:
//   starts and regions need
//                    a place good to a centimetre. Stored in scalp_field.bin, so that it must not move.
//   midlineLandmarks (midline_profile.h) exactly where is it, as anthropometry defines it? Only on a whole
//   nose.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "facenav/anatomy/front_relief.h"

namespace facenav::anatomy {

/// How far the midline stands out before both sides 30 mm away, mm; FrontRelief::kNone where unknown.
double prominence_mm(const FrontRelief& relief, int midline, int row);
/// Mean Mri y of both sides at `beside_mm` from the midline; FrontRelief::kNone where one has no skin.
double sides_mm(const FrontRelief& relief, int midline, int row, double beside_mm);

struct NoseRise {
  int root_row = 0;    // where the ridge begins to rise, between the eyes
  int crest_row = 0;   // where it stands out most
  double rise_mm = 0;  // by how much more than the forehead does
};
/// The strongest rise of the prominence within a nose's length, below the forehead. `relief`: rows from the
/// top.
std::optional<NoseRise> findNoseRise(const FrontRelief& relief, int midline);

/// The tip of the nose, Mri mm, or of what the scan has of it: where the front of the head stands out most
/// from the skin 25-35 mm to both sides. Independent of the head's pitch. `skin_mm`: at least one point, Mri.
Eigen::Vector3d findNoseTip(const std::vector<Eigen::Vector3d>& skin_mm);

}  // namespace facenav::anatomy
