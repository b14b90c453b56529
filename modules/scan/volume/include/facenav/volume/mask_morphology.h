#pragma once
// Morphology on masks by exact Euclidean distance in mm, any voxel size. A ball of any radius costs one
// distance map. Voxels outside the grid count as background for closing; for erosion the grid's edge is
// continued.

#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::volume {

/// Distance in mm of every voxel centre to the nearest set voxel's centre (0 in the mask). An empty mask
/// gives a large value everywhere.
std::vector<float> distanceTo(const Mask& mask);
/// Distance in mm of every set voxel to the nearest unset one.
std::vector<float> depthWithin(const Mask& mask);

Mask dilate(const Mask& mask, double radius_mm);
Mask erode(const Mask& mask, double radius_mm);
Mask close(const Mask& mask, double radius_mm);
Mask open(const Mask& mask, double radius_mm);

/// The 6-connected component with the most voxels; empty for an empty mask.
Mask largestPart(const Mask& mask);
/// All 6-connected components of at least `voxels` voxels.
Mask withoutSpecks(const Mask& mask, std::size_t voxels);
/// Background that is not connected to the grid's border becomes mask.
Mask fillHoles(const Mask& mask);
/// Fills background that is not connected to the voxels `outside` (by index; those inside the mask are
/// ignored).
Mask fillHolesFrom(const Mask& mask, const std::vector<std::size_t>& outside);

/// The voxels of the mask with at least one of the 6 neighbours outside the mask or the grid.
Mask surfaceVoxels(const Mask& mask);

Mask intersection(const Mask& a, const Mask& b);
Mask unionOf(const Mask& a, const Mask& b);
/// The voxels of `all` that can be reached from `seed` through `all` in `steps` 6-neighbour steps.
Mask grow(const Mask& seed, const Mask& all, int steps);

}  // namespace facenav::volume
