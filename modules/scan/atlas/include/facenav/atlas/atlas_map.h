#pragma once
// AtlasMap: MNI space <-> Mri. A point x of MNI space (RAS mm) maps to Mri = A (x + d(x)). d is given on a
// regular grid, linear between its nodes, and fades to 0 outside. Maps made by registerAtlas are smooth and
// invertible.

#include <array>
#include <filesystem>
#include <vector>

#include "facenav/geometry/point.h"
#include "facenav/volume/voxel_grid.h"

namespace facenav::atlas {

class AtlasMap {
 public:
  /// `mri_from_mni`: affine, mm. `grid`: parallel to the axes; its world is MNI space. `displacement_mm`: one
  /// per grid node.
  AtlasMap(const Eigen::Affine3d& mri_from_mni, const volume::VoxelGrid& grid,
           std::vector<Eigen::Vector3f> displacement_mm);

  Point<Mri> toMri(const Point<Mni>& p) const;
  /// Inverse of toMri, by fixed-point iteration to 0.01 mm.
  Point<Mni> toMni(const Point<Mri>& p) const;

  const Eigen::Affine3d& affine() const { return mri_from_mni_; }
  const volume::VoxelGrid& grid() const { return grid_; }
  const std::vector<Eigen::Vector3f>& displacement_mm() const { return displacement_mm_; }

 private:
  Eigen::Vector3d displacementAt(const Eigen::Vector3d& mni_mm) const;

  Eigen::Affine3d mri_from_mni_, mni_from_mri_, voxel_from_mni_;
  volume::VoxelGrid grid_;
  std::vector<Eigen::Vector3f> displacement_mm_;
};

/// Writes atlas.vti completely or not at all: displacement (steps of 0.01 mm) on the MNI grid, the affine as
/// field data.
void writeAtlasMap(const AtlasMap& map, const std::filesystem::path& path);
/// Throws Error if the file is missing, damaged or another kind of image.
AtlasMap readAtlasMap(const std::filesystem::path& path);

}  // namespace facenav::atlas
