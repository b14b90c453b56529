#pragma once
// Interpolation between edited slices: the outline of the slices between two drawn ones by the shape-based
// method (Raya and Udupa 1990): signed distance to each outline, blended linearly, cut at zero.

#include "facenav/editing/mask_change.h"

namespace facenav::editing {

/// `axis`: of the grid's indices (0..2); `slices`: two or more slice numbers along it, in any order. The
/// slices strictly between neighbouring ones are made anew. A slice without any mask counts as no outline:
/// nothing is made towards it. Throws Error for a slice outside the grid.
MaskChange interpolateSlices(const volume::Mask& mask, int axis, std::vector<int> slices);

}  // namespace facenav::editing
