#pragma once
// Region grow: from a click, all that hangs together with it and looks like it, within a ball.

#include "facenav/editing/brush.h"

namespace facenav::editing {

/// Values within `spread` standard deviations of the mean of the 27 voxels about the place. Throws Error
/// outside the volume.
ValueRange rangeAround(const volume::Volume& volume, const Point<Mri>& place, double spread = 2.5);

/// 6-connected voxels from the one at `seed` with values in `range`, no further than `reach_mm` from it;
/// added to the mask, or taken away. Nothing where the seed's own value lies outside the range.
MaskChange growRegion(const volume::Mask& mask, const volume::Volume& volume, const Point<Mri>& seed,
                      const ValueRange& range, double reach_mm, bool is_brain);

}  // namespace facenav::editing
