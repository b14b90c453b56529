#pragma once
// The brain as the region reached from its white matter downhill in intensity, as far as the fluid (after the
// cut of Dahnke, Yotter and Gaser, "Cortical thickness and central surface estimation", NeuroImage 65 (2013)
// 336-348). Dura and sinuses are as bright as cortex but lie beyond a film of fluid. On a path to them the
// image becomes darker and then brighter again; within the brain only noise does this.

#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// Scale of values: `floor` is 0, `top` is 1, clamped. `rise` is a share of that range.
struct DownhillRange {
  float floor = 0, top = 1;
  double rise = 0.08;
};

/// Voxels that a path of 6-neighbours through `within` connects to `seed`, such that no value on the path
/// lies more than `rise` above the lowest value before it. Of all paths to a voxel, the one with the highest
/// minimum counts. All three share one grid. `seed` belongs to the result where it lies in `within`.
volume::Mask growDownhill(const volume::Volume& image, const volume::Mask& seed, const volume::Mask& within,
                          const DownhillRange& range);

}  // namespace facenav::segmentation
