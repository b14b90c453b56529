#pragma once
// Normalises sharpness and noise. One head should give the same brain surface from coarse and fine voxels,
// with and without noise. Two effects move it. A wider point spread cuts the crowns of gyri and joins dura to
// them. Noise scatters voxels across the limit of tissue, and the closing of sulci joins them.

#include "brain_tissue.h"

namespace facenav::segmentation {

/// Variance (mm^2, per axis) of the image's actual point spread, which may differ from the voxel size
/// (resampling, averaging, motion). Tissue consists of steps, and the energy of the Laplacian of steps falls
/// with the point spread's sigma^-3 (power spectrum k^-4). The loss under a known smoothing therefore
/// determines the original sigma. Differences between two images of steps are right within an eighth; all
/// values are about 0.1 mm^2 too high because of the voxels. `image`: cubes of 1 mm, bias about even; `core`:
/// only brain; noise is measured in deep white matter. 0: cannot be estimated.
double pointSpread_mm2(const volume::Volume& image, const volume::Mask& core, const TissueModel& tissue);

/// Changes `image` (cubes of 1 mm on RAS axes) from its own point spread to the common one, 0.40 mm^2. Scans
/// of 1 mm are smoothed a little, those of 1.5 mm sharpened. The differences between axes follow from the
/// voxels of `scan`.
volume::Volume atCommonSharpness(const volume::Volume& image, const volume::VoxelGrid& scan,
                                 const volume::Mask& core, const TissueModel& tissue);

/// Standard deviation of the noise of single voxels, from white matter within `core`: scaled median of the
/// difference between a voxel and the mean of its six neighbours. `calm`: the image smoothed, same grid.
double noiseOf(const volume::Volume& flat, const volume::Volume& calm, const volume::Mask& core,
               const TissueModel& tissue);

/// Smooths as little as possible to bring noise of standard deviation `noise` to at most 0.09 of `contrast`
/// (the distance between fluid and grey matter). Unchanged if the noise is below that.
volume::Volume calmed(const volume::Volume& flat, double noise, double contrast);

}  // namespace facenav::segmentation
