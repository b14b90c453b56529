#pragma once
// One head scanned with coarse and with fine voxels, with and without noise, should show its brain's surface
// at one place. Two things move it: a wider point spread cuts the crowns of gyri and joins dura to them, and
// noise scatters voxels over the limit of tissue, which the closing of sulci then joins.

#include "brain_tissue.h"

namespace facenav::segmentation {

/// `image` (cubes of 1 mm on RAS axes) as sharp as a scan of 1 mm: where `scan` is coarser, the second moment
/// of its point spread is brought back to that of 1 mm, per axis, as far as 1.5 mm; beyond, the detail is
/// lost.
volume::Volume sharpAsOneMillimetre(const volume::Volume& image, const volume::VoxelGrid& scan);

/// Standard deviation of the noise of single voxels, from white matter within `core` (`calm`: the image
/// smoothed, same grid): the scaled median of what a voxel differs from the mean of its six neighbours.
double noiseOf(const volume::Volume& flat, const volume::Volume& calm, const volume::Mask& core,
               const TissueModel& tissue);

/// Smoothed by as little as brings noise of standard deviation `noise` to at most 0.09 of `contrast` (the
/// distance between fluid and grey matter); as it is where it lies below.
volume::Volume calmed(const volume::Volume& flat, double noise, double contrast);

}  // namespace facenav::segmentation
