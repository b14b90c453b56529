#include "scan_grid.h"

#include <algorithm>
#include <cmath>

#include "facenav/volume/regrid.h"
#include "facenav/volume/smoothing.h"

namespace facenav::segmentation {

using volume::Mask;
using volume::Volume;
using volume::VoxelGrid;

VoxelGrid partAround(const Mask& mask, double margin_mm) {
  const auto& n = mask.grid.size;
  std::array<int, 3> low = n, high{-1, -1, -1};
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        if (!mask.at(i, j, k)) continue;
        const std::array<int, 3> at{i, j, k};
        for (int a = 0; a < 3; ++a) low[a] = std::min(low[a], at[a]), high[a] = std::max(high[a], at[a]);
      }
  const int margin = int(margin_mm / mask.grid.spacing_mm().mean());
  VoxelGrid grid = mask.grid;
  for (int a = 0; a < 3; ++a) grid.size[a] = std::max(0, high[a] - low[a] + 1) + 2 * margin;
  grid.mri_from_voxel.translate(Eigen::Vector3d(low[0] - margin, low[1] - margin, low[2] - margin));
  return grid;
}

Mask onScanGrid(const Mask& brain, const VoxelGrid& grid) {
  const Volume level = volume::smoothed({brain.grid, {brain.voxels.begin(), brain.voxels.end()}, {}, {}});
  return volume::resampledAbove(level, 0.5f, grid);
}

Ball ballLike(const Mask& mask) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0;
  for (int k = 0; k < mask.grid.size[2]; ++k)
    for (int j = 0; j < mask.grid.size[1]; ++j)
      for (int i = 0; i < mask.grid.size[0]; ++i)
        if (mask.at(i, j, k)) sum += Eigen::Vector3d(i, j, k), ++count;
  return {mask.grid.toMri(sum / std::max(1.0, count)).mm, std::cbrt(mask.volume_ml() * 1e3 * 3 / (4 * M_PI))};
}

}  // namespace facenav::segmentation
