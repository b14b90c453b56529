#pragma once
// Direction of a coil's current as arrows to draw. Two files of one coil may be mirror images of each other,
// so the direction is shown and confirmed by a person, never guessed.

#include <vector>

#include "facenav/efield/coil_dipoles.h"

namespace facenav::efield {

/// Arrow along the current, frame Coil.
struct CurrentArrow {
  Eigen::Vector3d place_mm, along;  ///< along: unit vector in the plane of the contact face
  double strength = 0;              ///< 0..1, relative to the strongest arrow
};

/// Arrows on the plane of the contact face, `spacing_mm` apart, where the current is at least 40 % of the
/// strongest: its direction is that of the vector potential beside the winding.
std::vector<CurrentArrow> currentArrows(const CoilDipoles& coil, double spacing_mm = 11);

}  // namespace facenav::efield
