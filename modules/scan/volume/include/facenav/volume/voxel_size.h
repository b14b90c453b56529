#pragma once
// VoxelSize: judges the longest voxel edge of a navigation T1, with room for the rounding of scanners. The
// list of series, the import check and the window all ask here.

#include "facenav/volume/voxel_grid.h"

namespace facenav::volume {

enum class VoxelSize {
  fine,       // at most 1.2 mm
  coarse,     // at most 2 mm: the skin is placed less well
  too_coarse  // skin and cortex cannot be placed
};

constexpr double kUsableVoxel_mm = 2.005;

constexpr VoxelSize voxelSizeOf(double longest_mm) {
  return longest_mm <= kNavigationVoxel_mm ? VoxelSize::fine
         : longest_mm <= kUsableVoxel_mm   ? VoxelSize::coarse
                                           : VoxelSize::too_coarse;
}

}  // namespace facenav::volume
