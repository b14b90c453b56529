#pragma once
// Small volumes with known values for the tests of volume.

#include "facenav/volume/volume.h"

namespace facenav::testing {

/// Volume of 5 x 6 x 7 voxels of 1.5 x 0.8 x 2 mm, rotated, values i + 10 j + 100 k.
inline volume::Volume numberedVolume() {
  volume::Volume volume;
  volume.grid.size = {5, 6, 7};
  const Eigen::Matrix3d r =
      (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  volume.grid.mri_from_voxel.linear() = r * Eigen::Vector3d(1.5, 0.8, 2).asDiagonal();
  volume.grid.mri_from_voxel.translation() = Eigen::Vector3d(-10, 20, 30);
  for (int k = 0; k < 7; ++k)
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 5; ++i) volume.voxels.push_back(float(i + 10 * j + 100 * k));
  return volume;
}

}  // namespace facenav::testing
