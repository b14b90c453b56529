#pragma once
// Region grow: from a click, all connected voxels with similar values, within a ball.

#include "facenav/editing/brush.h"

namespace facenav::editing {

/// Range of values within `spread` standard deviations of the mean of the 27 voxels around `place`. Throws
/// Error outside the volume.
ValueRange rangeAround(const volume::Volume& volume, const Point<Mri>& place, double spread = 2.5);

/// Adds to the mask, or removes from it, the voxels with values in `range` that are 6-connected to the voxel
/// at `seed` and at most `reach_mm` from it. The change is empty if the seed's own value is outside the
/// range.
MaskChange growRegion(const volume::Mask& mask, const volume::Volume& volume, const Point<Mri>& seed,
                      const ValueRange& range, double reach_mm, bool is_brain);

}  // namespace facenav::editing
