#pragma once
// A little smoothing on the grid, which takes the steps off a mask and the noise off a voxel.

#include "facenav/volume/volume.h"

namespace facenav::volume {

/// One pass of the kernel 1-2-1 along each axis: sigma 0.7 voxels. The grid's outermost voxels stay as they
/// are along the axis that ends there.
Volume smoothed(Volume volume);

}  // namespace facenav::volume
