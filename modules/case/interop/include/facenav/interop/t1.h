#pragma once
// T1: the grid of an MRI with both maps of its NIfTI header, as other programs' files refer to it.

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "facenav/interop/item.h"
#include "facenav/volume/voxel_grid.h"

namespace facenav::interop {

struct T1 {
  std::filesystem::path path;
  volume::VoxelGrid grid;                       // the world Mri: sform, else qform
  std::string used;                             // "sform" or "qform"
  std::optional<Eigen::Affine3d> sform, qform;  // voxel to world, mm; nothing where its code is 0
  QformNumbers qform_numbers;                   // of the qform
  /// The map of a form; for `any` that of the grid. Throws Error if the file lacks it.
  const Eigen::Affine3d& map(Form form) const;
  /// Largest distance between the two forms at the corners of the grid, mm; 0 where one is absent.
  double formsApart_mm() const;
};

/// Reads the header. Throws Error as volume::readNifti does.
T1 readT1(const std::filesystem::path& path);

/// Largest distance between two maps at the corners of a grid of this size, mm.
double cornersApart_mm(const Eigen::Affine3d& a, const Eigen::Affine3d& b, const std::array<int, 3>& size);

/// Returns the same voxels in the order right, anterior, superior, as nibabel's as_closest_canonical stores
/// them.
volume::VoxelGrid canonical(const volume::VoxelGrid& grid);
/// The grid of an image of which only the map is known, in the order right, anterior, superior, if it has as
/// many voxels along each of these directions as `like`.
volume::VoxelGrid canonicalOf(const Eigen::Affine3d& map, const volume::VoxelGrid& like);

}  // namespace facenav::interop
