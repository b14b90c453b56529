#pragma once
// Dilation by a ball, in rows of bits: each row of voxels is 64 to a word, is widened by every number of
// steps that the ball needs once, and the widened rows of a slice are then united whole. Exact, whatever the
// spacing. For radii of some tens of voxels; beyond, an envelope of distances (mask_morphology.cpp) is
// faster.

#include <cstdint>
#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::volume {

/// 1 where a voxel of the mask that is set (is_set), or is not, lies within sqrt(`squared_radius_mm2`) of the
/// voxel, 0 elsewhere; beyond the grid lies neither.
std::vector<std::uint8_t> withinBall(const Mask& mask, bool is_set, float squared_radius_mm2);

}  // namespace facenav::volume
