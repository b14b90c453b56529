#pragma once
// Local means of chosen voxels: the level of tissue, air or haze near each place, where shading makes one
// level for the whole scan wrong.

#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::volume {

/// Mean of the values where `counts` is set, about each voxel: three passes of a box `reach_mm` wide (a bell
/// of sigma reach_mm / 2). Returns `otherwise` where none is near.
std::vector<float> localMean(const VoxelGrid& grid, const std::vector<float>& values,
                             const std::vector<std::uint8_t>& counts, double reach_mm, float otherwise);

}  // namespace facenav::volume
