#pragma once
// Both maps of a NIfTI header, sform and qform, and the numbers of the qform as they stand in the file. For
// files of other programs, which name one of the forms; everything else reads the volume (nifti.h).

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "facenav/volume/voxel_grid.h"

namespace facenav::volume {

struct NiftiForms {
  VoxelGrid grid;                               // the map that readNifti takes unasked
  std::string used;                             // its name: "sform" or "qform"
  std::optional<Eigen::Affine3d> sform, qform;  // voxel to world, mm; nothing where the code is 0
  std::array<double, 3> quatern{}, offset{};    // of the qform
  std::array<double, 4> pixdim{};               // pixdim[0]: qfac, 1 or -1
  int values = 1;                               // of a voxel: product of all dimensions after the third
  bool holds_fractions = false;                 // values of floating point
  bool is_template_space = false;               // the map of `used` leads to a template, by its code
};

/// Reads the header only. Throws Error: no such file, not NIfTI-1, no 3-D grid, or as readNifti for its map.
NiftiForms readNiftiForms(const std::filesystem::path& path);

}  // namespace facenav::volume
