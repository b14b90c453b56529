#pragma once
// Morphology on masks by exact Euclidean distance in mm, any voxel size: balls of any radius at the price of
// one distance map. Outside the grid counts as background for closing, and as a continuation of the edge for
// erosion.

#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::volume {

/// Distance in mm of every voxel centre to the nearest set voxel's centre (0 in the mask). A large value
/// throughout for an empty mask.
std::vector<float> distanceTo(const Mask& mask);
/// Distance in mm of every set voxel to the nearest unset one.
std::vector<float> depthWithin(const Mask& mask);

Mask dilate(const Mask& mask, double radius_mm);
Mask erode(const Mask& mask, double radius_mm);
Mask close(const Mask& mask, double radius_mm);
Mask open(const Mask& mask, double radius_mm);

/// The 6-connected part with the most voxels; empty for an empty mask.
Mask largestPart(const Mask& mask);
/// Every 6-connected part of at least `voxels`.
Mask withoutSpecks(const Mask& mask, std::size_t voxels);
/// Background that cannot be reached from the grid's border becomes mask.
Mask fillHoles(const Mask& mask);
/// The same with background that cannot be reached from the voxels `outside` (by index; those of the mask are
/// no way in).
Mask fillHolesFrom(const Mask& mask, const std::vector<std::size_t>& outside);

/// The voxels of the mask of which one of the 6 neighbours is not in it or lies beyond the grid.
Mask surfaceVoxels(const Mask& mask);

Mask intersection(const Mask& a, const Mask& b);
Mask unionOf(const Mask& a, const Mask& b);
/// The voxels of `all` that can be reached from `seed` through `all` in `steps` 6-neighbour steps.
Mask grow(const Mask& seed, const Mask& all, int steps);

}  // namespace facenav::volume
