#pragma once
// One head scanned with coarse and with fine voxels, with and without noise, should show its brain's surface
// at one place. Two things move it: a wider point spread cuts the crowns of gyri and joins dura to them, and
// noise scatters voxels over the limit of tissue, which the closing of sulci then joins.

#include "brain_tissue.h"

namespace facenav::segmentation {

/// Variance (mm^2, per axis) of the point spread that the image itself shows, whatever the size of the voxels
/// says of it (resampling, averaging, motion). Tissue is made of steps, and the energy of the Laplacian of
/// steps falls with the point spread's sigma^-3 (power spectrum k^-4): what a smoothing by a known amount
/// takes off tells how much was there. Two images of steps differ in it as they were blurred, within an
/// eighth; all are stated some 0.1 mm^2 too high, which the voxels add. `image`: cubes of 1 mm, bias about
/// even; `core`: nothing but brain; the noise is that of deep white matter. 0 where nothing can be told.
double pointSpread_mm2(const volume::Volume& image, const volume::Mask& core, const TissueModel& tissue);

/// `image` (cubes of 1 mm on RAS axes) brought from the point spread it shows to the one at which all scans
/// are judged, 0.40 mm^2: scans of 1 mm are smoothed a little, those of 1.5 mm sharpened. How
/// the axes differ is told by the voxels of `scan`.
volume::Volume atCommonSharpness(const volume::Volume& image, const volume::VoxelGrid& scan,
                                 const volume::Mask& core, const TissueModel& tissue);

/// Standard deviation of the noise of single voxels, from white matter within `core` (`calm`: the image
/// smoothed, same grid): the scaled median of what a voxel differs from the mean of its six neighbours.
double noiseOf(const volume::Volume& flat, const volume::Volume& calm, const volume::Mask& core,
               const TissueModel& tissue);

/// Smoothed by as little as brings noise of standard deviation `noise` to at most 0.09 of `contrast` (the
/// distance between fluid and grey matter); as it is where it lies below.
volume::Volume calmed(const volume::Volume& flat, double noise, double contrast);

}  // namespace facenav::segmentation
