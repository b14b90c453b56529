#pragma once
// Dilation by a ball, on rows of bits (64 voxels per word). Each row is widened once by every half width that
// the ball needs; then the widened rows of a slice are combined by OR. Exact for any spacing. For radii of
// some tens of voxels; above that, the lower envelope of distances (mask_morphology.cpp) is faster.

#include <cstdint>
#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::volume {

/// Dilates by a ball: 1 if a voxel of the mask that is set (or unset, if `is_set` is false) lies within
/// sqrt(`squared_radius_mm2`) of the voxel, else 0. Outside the grid there are no voxels of either kind.
std::vector<std::uint8_t> withinBall(const Mask& mask, bool is_set, float squared_radius_mm2);

}  // namespace facenav::volume
