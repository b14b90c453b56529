#pragma once
// A little smoothing on the grid, which takes the steps off a mask and the noise off a voxel.

#include "facenav/volume/volume.h"

namespace facenav::volume {

/// One pass of the kernel 1-2-1 along each axis: sigma 0.7 voxels. The grid's outermost voxels stay as they
/// are along the axis that ends there.
Volume smoothed(Volume volume);
/// One pass of the kernel (v/2, 1 - v, v/2) along each axis, v = `variance` in voxels^2, -0.5 .. 0.5: what it
/// adds to the variance of the image's point spread. Negative: takes off as much (sharper, noise grows).
Volume spread(Volume volume, const Eigen::Vector3d& variance);

}  // namespace facenav::volume
