#pragma once
// Random small coils where a coil's winding may be: what the modes are made from.

#include "modes/coil_rows.h"

namespace facenav::efield {

/// Makes flat patches of parallel dipoles, 10 to 60 mm off the scalp and about parallel to it, above
/// `lowest_z_mm`. A patch is 36 mm wide, so that the modes are not spent on fields which only a coil of a few
/// mm could make: 192 modes then leave 0.5 % in place of 2.5 % of a figure-8 coil's field in a sphere.
SourceArray trainingSources(const ShellMesh& scalp, double lowest_z_mm, int count, unsigned seed);

}  // namespace facenav::efield
