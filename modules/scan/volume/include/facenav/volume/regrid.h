#pragma once
// Regridding: the same anatomy on another grid. Algorithms that need a canonical axis order or cubic voxels
// convert their input and convert their masks back.

#include <optional>

#include "facenav/volume/volume.h"

namespace facenav::volume {

/// Permutes and flips axes (no interpolation) so that i, j, k are as close as possible to +R, +A, +S.
Volume toRasOrder(const Volume& volume);
Mask toRasOrder(const Mask& mask);

/// The same mask on `grid` if both grids hold the same voxels and differ in the order or direction of their
/// axes alone (within 1e-3 mm); otherwise nullopt.
std::optional<Mask> reordered(const Mask& mask, const VoxelGrid& grid);

/// Resamples trilinearly onto `grid` (0 outside). Values are not pre-smoothed for a coarser `grid`.
Volume resample(const Volume& volume, const VoxelGrid& grid);
/// Resamples trilinearly what each value lies above `floor` (0 outside, and where a value is not finite).
Volume resampleAbove(const Volume& volume, float floor, const VoxelGrid& grid);
/// Resamples by cubic convolution (Keys 1981, a = -1/2) onto `grid` (0 outside). It keeps edges that
/// trilinear interpolation between coarse voxels would blur; it may overshoot beside an edge by a few
/// hundredths.
Volume resampleCubic(const Volume& volume, const VoxelGrid& grid);
/// The voxels of `grid` where the trilinearly interpolated volume (0 outside) is at least `least`.
Mask resampledAbove(const Volume& volume, float least, const VoxelGrid& grid);
/// The mask's share of each place of `grid`, 0 to 1, interpolated trilinearly (0 outside).
Volume shareOn(const Mask& mask, const VoxelGrid& grid);
/// Resamples a mask onto `grid`: a voxel is set if the trilinearly interpolated mask is at least 0.5 there.
Mask resample(const Mask& mask, const VoxelGrid& grid);

/// Axis-aligned RAS grid with cubic voxels that covers `grid`.
VoxelGrid isotropicGrid(const VoxelGrid& grid, double spacing_mm);
/// Axis-aligned RAS grid with cubic voxels around the set voxels, with a margin. Throws Error for an empty
/// mask.
VoxelGrid gridAround(const Mask& mask, double spacing_mm, double margin_mm);

}  // namespace facenav::volume
