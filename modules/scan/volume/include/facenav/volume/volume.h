#pragma once
// Volume: an MRI (rescaled values, 32-bit float, exact for integers up to 2^24) on its grid. Mask: 0/1 voxels
// on a grid.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "facenav/volume/voxel_grid.h"

namespace facenav::volume {

struct Volume {
  VoxelGrid grid;
  std::vector<float> voxels;
  std::string modality = "MR";     // DICOM modality code ("MR", "CT"); "" if unknown (NIfTI)
  std::string orientation_source;  // source of the world coordinates: "DICOM", "sform", "qform"

  float at(int i, int j, int k) const { return voxels[grid.index(i, j, k)]; }
};

struct Mask {
  VoxelGrid grid;
  std::vector<std::uint8_t> voxels;  // 0 or 1

  bool at(int i, int j, int k) const { return voxels[grid.index(i, j, k)] != 0; }
  double volume_ml() const;
};

/// Trilinear value at continuous voxel coordinates; `outside` beyond the outermost voxel centres.
float sampleLinear(const Volume& volume, const Eigen::Vector3d& ijk, float outside = 0.f);
/// Trilinear value of a mask, 0 to 1.
float sampleLinear(const Mask& mask, const Eigen::Vector3d& ijk, float outside = 0.f);
/// The value of the voxel that contains `p`; nullopt outside the volume.
std::optional<float> valueAt(const Volume& volume, const Point<Mri>& p);
/// The value below which `fraction` (0..1) of all finite voxels lie. Uses a sample of up to 2 million voxels.
float percentile(const Volume& volume, double fraction);

struct Overlap {
  double dice;    // 2 |A and B| / (|A| + |B|)
  double inside;  // share of A that lies inside B
};
/// Throws Error unless both grids match.
Overlap overlap(const Mask& a, const Mask& b);

}  // namespace facenav::volume
