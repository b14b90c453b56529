#pragma once
// The brain as what is reached from its white matter by going downhill in intensity, to the fluid and no
// further (after the cut of Dahnke, Yotter and Gaser, "Cortical thickness and central surface estimation",
// NeuroImage 65 (2013) 336-348). Dura and sinuses, as bright as cortex, lie beyond a film of fluid, however
// thin: on the way to them the image grows darker and then brighter again, which within the brain only noise
// does.

#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// How values are read: from `floor` (0) to `top` (1), as 0 or 1 beyond; `rise` is a share of that range.
struct DownhillRange {
  float floor = 0, top = 1;
  double rise = 0.08;
};

/// What a path of 6-neighbours joins to `seed` through `within`, along which no value lies more than `rise`
/// above the lowest one before it. Of all paths to a voxel the one counts whose lowest value is highest. The
/// three share one grid; `seed` lies in the result where it lies in `within`.
volume::Mask growDownhill(const volume::Volume& image, const volume::Mask& seed, const volume::Mask& within,
                          const DownhillRange& range);

}  // namespace facenav::segmentation
