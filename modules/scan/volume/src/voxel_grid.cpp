#include "facenav/volume/voxel_grid.h"

#include <cmath>

namespace facenav::volume {

Eigen::Vector3d VoxelGrid::spacing_mm() const { return mri_from_voxel.linear().colwise().norm(); }

double VoxelGrid::voxelVolume_mm3() const { return std::abs(mri_from_voxel.linear().determinant()); }

Point<Mri> VoxelGrid::centre() const {
  return toMri({(size[0] - 1) / 2.0, (size[1] - 1) / 2.0, (size[2] - 1) / 2.0});
}

bool VoxelGrid::matches(const VoxelGrid& other) const {
  if (size != other.size) return false;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d ijk((corner & 1) * size[0], ((corner >> 1) & 1) * size[1], (corner >> 2) * size[2]);
    if ((toMri(ijk).mm - other.toMri(ijk).mm).norm() > 1e-3) return false;
  }
  return true;
}

}  // namespace facenav::volume
