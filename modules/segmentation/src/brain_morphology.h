#pragma once
// Morphology on masks with cubic voxels, by exact Euclidean distance: balls of any radius at the price of one
// distance map. Outside the grid counts as background for closing, and as a continuation of the edge for
// erosion.

#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// Distance in mm of every voxel centre to the nearest set voxel's centre (0 in the mask). A large value
/// throughout for an empty mask.
std::vector<float> distanceTo(const volume::Mask& mask);
/// Distance in mm of every set voxel to the nearest unset one.
std::vector<float> depthWithin(const volume::Mask& mask);

volume::Mask dilate(const volume::Mask& mask, double radius_mm);
volume::Mask erode(const volume::Mask& mask, double radius_mm);
volume::Mask close(const volume::Mask& mask, double radius_mm);
volume::Mask open(const volume::Mask& mask, double radius_mm);

/// The 6-connected part with the most voxels; empty for an empty mask.
volume::Mask largestPart(const volume::Mask& mask);
/// Every 6-connected part of at least `voxels`.
volume::Mask withoutSpecks(const volume::Mask& mask, std::size_t voxels);
/// Background that cannot be reached from the grid's border becomes mask.
volume::Mask fillHoles(const volume::Mask& mask);

volume::Mask intersection(const volume::Mask& a, const volume::Mask& b);
volume::Mask unionOf(const volume::Mask& a, const volume::Mask& b);
/// The voxels of `all` that can be reached from `seed` through `all` in `steps` 6-neighbour steps.
volume::Mask grow(const volume::Mask& seed, const volume::Mask& all, int steps);

}  // namespace facenav::segmentation
