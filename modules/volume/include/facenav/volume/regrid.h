#pragma once
// Regridding: the same anatomy on another grid. Algorithms that want a canonical order or cubic voxels
// convert at their door and convert their masks back.

#include "facenav/volume/volume.h"

namespace facenav::volume {

/// Axes permuted and flipped (no interpolation) so that i, j, k run as nearly as possible along +R, +A, +S.
Volume toRasOrder(const Volume& volume);
Mask toRasOrder(const Mask& mask);

/// Trilinear onto `grid` (0 outside). When `grid` is coarser the values are not pre-smoothed.
Volume resample(const Volume& volume, const VoxelGrid& grid);
/// By cubic convolution (Keys 1981, a = -1/2) onto `grid` (0 outside): keeps the edges that trilinear sampling
/// between coarse voxels would blur; may overshoot beside them by some hundredths.
Volume resampleCubic(const Volume& volume, const VoxelGrid& grid);
/// Onto `grid`: a voxel is set where the trilinearly interpolated mask reaches 0.5.
Mask resample(const Mask& mask, const VoxelGrid& grid);

/// Axis-aligned RAS grid with cubic voxels that covers `grid`.
VoxelGrid isotropicGrid(const VoxelGrid& grid, double spacing_mm);
/// Likewise, around the voxels that are set, with a margin. Throws Error for an empty mask.
VoxelGrid gridAround(const Mask& mask, double spacing_mm, double margin_mm);

}  // namespace facenav::volume
