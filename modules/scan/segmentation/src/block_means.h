#pragma once
// Means of blocks of about 2 mm, where noise and ghosts are weak.

#include <array>
#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::segmentation {

struct BlockMeans {
  std::array<int, 3> block;  // voxels of the scan along each axis
  volume::VoxelGrid grid;
  std::vector<float> mean;
};

/// Block means on the scan's own axes. Values that are not finite count as missing; a block of them gives 0.
BlockMeans blockMeans(const volume::Volume& volume);

}  // namespace facenav::segmentation
