#pragma once
// Means of chosen voxels place by place: the level of tissue, air or haze where shading makes one level for
// the whole scan wrong.

#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::volume {

/// Mean of the values where `counts` is set, about each voxel: three passes of a box `reach_mm` wide (a bell
/// of sigma reach_mm / 2). `otherwise` where none is near.
std::vector<float> localMean(const VoxelGrid& grid, const std::vector<float>& values,
                             const std::vector<std::uint8_t>& counts, double reach_mm, float otherwise);

}  // namespace facenav::volume
