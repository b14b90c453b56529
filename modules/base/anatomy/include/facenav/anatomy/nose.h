#pragma once
// Finds the nose on the skin. Two searches use how far the skin stands out from the cheeks beside it, and how
// far forward it lies. (Whether there is a face at all: face_match.h.)
// - findNoseTip: about where is its tip? It always returns a place, also when the scan cuts the nose, because
//   starts and regions need a place exact to a centimetre. Stored in scalp_field.bin, so its result must not
//   change.
// - midlineLandmarks (midline_profile.h): where exactly is it, by the anthropometric definition? Only on a
//   whole nose.

#include <Eigen/Core>
#include <vector>

#include "facenav/anatomy/front_relief.h"

namespace facenav::anatomy {

/// The tip of the nose, or of its part inside the scan, Mri mm: where the front of the head stands out most
/// from the skin 25-35 mm to both sides. Independent of the head's pitch. `skin_mm`: at least one point, Mri.
Eigen::Vector3d findNoseTip(const std::vector<Eigen::Vector3d>& skin_mm);

}  // namespace facenav::anatomy
