#pragma once
// Masks in closed form on an oblique grid with unequal spacing, like scans from hospitals.

#include "facenav/volume/volume.h"

namespace facenav::testing {

inline volume::VoxelGrid obliqueGrid(int n = 64) {
  volume::VoxelGrid grid;
  grid.size = {n, n - 4, n - 8};
  grid.mri_from_voxel = Eigen::Translation3d(-20, 5, 40) *
                        Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 0.5).normalized()) *
                        Eigen::Scaling(0.8, 1.0, 1.3);
  return grid;
}

inline volume::Mask emptyMask(const volume::VoxelGrid& grid) {
  return {grid, std::vector<std::uint8_t>(grid.count(), 0)};
}

inline volume::Mask ballMask(const volume::VoxelGrid& grid, const Point<Mri>& centre, double radius_mm) {
  volume::Mask mask = emptyMask(grid);
  std::size_t v = 0;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i, ++v)
        mask.voxels[v] = (grid.toMri({double(i), double(j), double(k)}).mm - centre.mm).norm() <= radius_mm;
  return mask;
}

/// A volume whose values are the voxels' index along the first axis.
inline volume::Volume ramp(const volume::VoxelGrid& grid) {
  volume::Volume volume;
  volume.grid = grid;
  for (std::size_t v = 0; v < grid.count(); ++v) volume.voxels.push_back(float(v % grid.size[0]));
  return volume;
}

}  // namespace facenav::testing
