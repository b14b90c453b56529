#pragma once
// Light smoothing on the grid, which removes the steps of a mask and the noise of single voxels.

#include "facenav/volume/volume.h"

namespace facenav::volume {

/// Applies one pass of the kernel 1-2-1 along each axis: sigma 0.7 voxels. At both ends of an axis, the
/// outermost voxels are not smoothed along that axis.
Volume smoothed(Volume volume);
/// Applies one pass of the kernel (v/2, 1 - v, v/2) along each axis. v = `variance` in voxels^2, -0.5 .. 0.5,
/// is added to the variance of the image's point spread. A negative v sharpens the image and amplifies noise.
Volume spread(Volume volume, const Eigen::Vector3d& variance);

}  // namespace facenav::volume
