#pragma once
// VoxelGrid: where voxels are in the patient. Index (i, j, k) counts voxel centres, i fastest in memory; the
// affine maps indices to Mri (RAS, mm). Any axis order, flip and obliquity is possible; no code may assume
// axis alignment.

#include <Eigen/Geometry>
#include <array>
#include <cstddef>

#include "facenav/geometry/point.h"

namespace facenav::volume {

/// Largest voxel edge accepted for a navigation T1: 1.2 mm, with room for the rounding of scanners.
constexpr double kNavigationVoxel_mm = 1.205;

struct VoxelGrid {
  std::array<int, 3> size{0, 0, 0};
  Eigen::Affine3d mri_from_voxel = Eigen::Affine3d::Identity();

  std::size_t count() const { return std::size_t(size[0]) * size[1] * size[2]; }
  std::size_t index(int i, int j, int k) const {
    return i + std::size_t(size[0]) * (j + std::size_t(size[1]) * k);
  }
  bool contains(int i, int j, int k) const {
    return i >= 0 && j >= 0 && k >= 0 && i < size[0] && j < size[1] && k < size[2];
  }
  /// Length of one step along each index axis, mm.
  Eigen::Vector3d spacing_mm() const;
  double voxelVolume_mm3() const;
  Point<Mri> toMri(const Eigen::Vector3d& ijk) const { return Point<Mri>(mri_from_voxel * ijk); }
  Eigen::Vector3d toVoxel(const Point<Mri>& p) const { return mri_from_voxel.inverse() * p.mm; }
  Point<Mri> centre() const;
  /// True for the same size and the same affine within 1e-3 mm over the whole grid.
  bool matches(const VoxelGrid& other) const;
};

}  // namespace facenav::volume
