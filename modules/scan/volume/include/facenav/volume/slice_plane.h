#pragma once
// SlicePlane: any plane through the patient, and the image of a volume or mask on it. Used by the slice
// views, the report's pictures and the alignment's cross-sections. Anatomical planes follow the radiological
// convention: the patient's right is on the image's left.

#include <cstdint>
#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::volume {

enum class Anatomical { axial, coronal, sagittal };

/// A plane: image pixel (u, v) with u right and v down lies at origin + spacing * (u * right + v * down), Mri
/// mm.
struct SlicePlane {
  Point<Mri> origin;  // centre of the top-left pixel
  Direction<Mri> right, down;
  double spacing_mm = 1.0;
  int width = 0, height = 0;

  Point<Mri> toMri(double u, double v) const {
    return Point<Mri>(origin.mm + spacing_mm * (u * right.v + v * down.v));
  }
  /// (u, v, distance to the plane in mm) of a point.
  Eigen::Vector3d toPixel(const Point<Mri>& p) const;
};

/// The anatomical plane through the point `through`; it covers the whole grid.
SlicePlane anatomicalPlane(const VoxelGrid& grid, Anatomical orientation, const Point<Mri>& through,
                           double spacing_mm = 1.0);

/// The index axis (0..2) of the grid that counts slices with this normal.
int sliceAxis(const VoxelGrid& grid, const Direction<Mri>& normal);

/// Number of the grid's slice that a plane shows, counted from 1 in the file's order; 0: outside the grid.
struct SliceNumber {
  int number = 0, count = 0;
};
SliceNumber sliceNumber(const VoxelGrid& grid, const SlicePlane& plane);

/// Samples a volume trilinearly: row-major values, width x height; 0 outside the volume.
std::vector<float> sampleSlice(const Volume& volume, const SlicePlane& plane);
/// Samples a mask by its nearest voxel: row-major 0/1.
std::vector<std::uint8_t> sampleSlice(const Mask& mask, const SlicePlane& plane);

}  // namespace facenav::volume
