#pragma once
// The box of voxels within reach of a point. Tools visit only these voxels, not the whole grid.

#include <algorithm>
#include <cmath>

#include "facenav/volume/volume.h"

namespace facenav::editing {

struct VoxelBox {
  Eigen::Array3i low, high;  // both included; empty if low > high
  bool isEmpty() const { return (low > high).any(); }
};

/// All voxels whose centres may lie within `reach_mm` of the box (Mri mm).
inline VoxelBox boxAround(const volume::VoxelGrid& grid, const Eigen::AlignedBox3d& box_mm, double reach_mm) {
  const Eigen::Affine3d to_voxel = grid.mri_from_voxel.inverse();
  Eigen::AlignedBox3d box;
  for (int corner = 0; corner < 8; ++corner) {
    const auto type = static_cast<Eigen::AlignedBox3d::CornerType>(corner);
    box.extend(to_voxel * box_mm.corner(type));
  }
  const Eigen::Array3d reach = reach_mm / grid.spacing_mm().array();
  const Eigen::Array3i last(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1);
  const Eigen::Array3d far = (last + 2).cast<double>();
  return {(box.min().array() - reach).ceil().max(0.0).min(far).cast<int>(),
          (box.max().array() + reach).floor().max(-1.0).min(last.cast<double>()).cast<int>()};
}

/// Calls visit(voxel index, centre in Mri mm) for each voxel of the box.
template <class Visit>
void forVoxelsNear(const volume::VoxelGrid& grid, const Eigen::AlignedBox3d& box_mm, double reach_mm,
                   Visit&& visit) {
  const VoxelBox box = boxAround(grid, box_mm, reach_mm);
  if (box.isEmpty()) return;
  for (int k = box.low[2]; k <= box.high[2]; ++k)
    for (int j = box.low[1]; j <= box.high[1]; ++j)
      for (int i = box.low[0]; i <= box.high[0]; ++i)
        visit(grid.index(i, j, k), grid.mri_from_voxel * Eigen::Vector3d(i, j, k));
}

/// Half the extent of a voxel along this normal: a slice one voxel thick contains the centres within this
/// distance.
inline double halfThickness_mm(const volume::VoxelGrid& grid, const Eigen::Vector3d& normal) {
  return 0.5 * (grid.mri_from_voxel.linear().transpose() * normal).cwiseAbs().maxCoeff();
}

/// The box of the set voxels, enlarged by `rim` voxels but kept inside the grid.
inline VoxelBox boxOf(const volume::Mask& mask, int rim) {
  const auto& n = mask.grid.size;
  VoxelBox box{{n[0], n[1], n[2]}, {-1, -1, -1}};
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j) {
      const auto* row = &mask.voxels[mask.grid.index(0, j, k)];
      const auto* end = row + n[0];
      const auto* first = std::find_if(row, end, [](auto v) { return v != 0; });
      if (first == end) continue;
      const auto* last = end - 1;
      while (!*last) --last;
      box.low = box.low.min(Eigen::Array3i(int(first - row), j, k));
      box.high = box.high.max(Eigen::Array3i(int(last - row), j, k));
    }
  if (box.isEmpty()) return box;
  box.low = (box.low - rim).max(0);
  box.high = (box.high + rim).min(Eigen::Array3i(n[0] - 1, n[1] - 1, n[2] - 1));
  return box;
}

}  // namespace facenav::editing
