#pragma once
// MaskAgreement: compares a brain mask with a true one, for `facenav evaluate prepare`. Exact definitions:
// - Dice = 2 |A and B| / (|A| + |B|), over voxels of the truth's grid.
// - Inside = |A and B| / |A|, where A is the found mask.
// - Surface voxels of a mask: its voxels with at least one of the 6 neighbours outside the mask or the grid.
// - 95 % Hausdorff distance: the distances (mm) from the centre of every surface voxel of A to the nearest
//   one of B; their 95th percentile (the smallest value such that 95 % of all are at or below it); the same
//   from B to A; the larger of both.
// - Closing of a truth by n voxels: all voxels within n * spacing of the mask (Euclidean ball, voxel
//   centres), minus all voxels within n * spacing of the remaining background (spacing: the mean of the
//   three). Voxels outside the grid are background.
// - Filling: background that no 6-connected path joins to the grid's border becomes mask.

#include "facenav/volume/volume.h"

namespace facenav::evaluation {

struct MaskAgreement {
  double dice = 0, inside = 0;
  double hausdorff95_mm = 0, mean_distance_mm = 0;  // mean: over the surface voxels of both
  double found_ml = 0, true_ml = 0;
};

/// Compares two masks. If the grids differ, `found` is resampled to the truth's grid (a voxel is set if its
/// trilinear value is at least 0.5). Throws Error if either mask is empty.
MaskAgreement compareMasks(const volume::Mask& found, const volume::Mask& truth);

/// Makes a true mask from tissue labels with open sulci: closed by `closing_voxels`, holes filled.
volume::Mask closedAndFilled(const volume::Mask& tissue, double closing_voxels = 2);

}  // namespace facenav::evaluation
