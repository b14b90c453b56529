#pragma once
// MaskAgreement: a brain mask beside a true one, as `facenav evaluate prepare` states it. Definitions,
// exactly:
// - Dice = 2 |A and B| / (|A| + |B|), over voxels of the truth's grid.
// - Inside = |A and B| / |A|, A the mask that was found.
// - Surface voxels of a mask: its voxels of which one of the 6 neighbours is not in it (or lies beyond the
// grid).
// - 95 % Hausdorff distance: from the centre of every surface voxel of A to the nearest of B, mm, their 95th
//   percentile (the smallest value with 95 % of all at or below it); the same from B to A; the larger of
//   both.
// - Closing of a truth by n voxels: all within n * spacing of the mask (Euclidean ball, voxel centres), less
// all
//   within n * spacing of what is left (spacing: the mean of the three); beyond the grid is background.
//   Filling: background that no 6-connected path joins to the grid's border becomes mask.

#include "facenav/volume/volume.h"

namespace facenav::evaluation {

struct MaskAgreement {
  double dice = 0, inside = 0;
  double hausdorff95_mm = 0, mean_distance_mm = 0;  // mean: over the surface voxels of both
  double found_ml = 0, true_ml = 0;
};

/// `found` is brought onto the truth's grid where the grids differ (a voxel is set where its trilinear value
/// reaches 0.5). Throws Error where either mask is empty.
MaskAgreement compareMasks(const volume::Mask& found, const volume::Mask& truth);

/// Tissue labels with open sulci as a true mask: closed by `closing_voxels`, holes filled.
volume::Mask closedAndFilled(const volume::Mask& tissue, double closing_voxels = 2);

}  // namespace facenav::evaluation
