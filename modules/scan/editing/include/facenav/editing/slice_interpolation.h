#pragma once
// Interpolation between edited slices by the shape-based method (Raya and Udupa 1990): the signed distances
// to the outlines of two drawn slices are blended linearly and cut at zero.

#include "facenav/editing/mask_change.h"

namespace facenav::editing {

/// Interpolates. `axis`: index axis of the grid (0..2). `slices`: two or more slice numbers along it, in any
/// order. The slices strictly between neighbouring ones are replaced. A slice without mask voxels has no
/// outline, so nothing is interpolated towards it. Throws Error for a slice outside the grid.
MaskChange interpolateSlices(const volume::Mask& mask, int axis, std::vector<int> slices);

}  // namespace facenav::editing
