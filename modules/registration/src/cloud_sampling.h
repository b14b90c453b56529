#pragma once
// Thinning of the face cloud: even density, so that near and well lit skin counts no more than the rest.

#include <cstdint>
#include <vector>

#include "facenav/geometry/point.h"

namespace facenav::registration {

/// Indices of at most `most` finite points, one per cube of `cell_mm` (the one first in a seeded order); the
/// cubes are enlarged until the number fits.
std::vector<int> thinOut(const PointCloud<Camera>& cloud, double cell_mm, std::size_t most,
                         std::uint32_t seed = 1);

/// The points picked by `indices`.
PointCloud<Camera> pick(const PointCloud<Camera>& cloud, const std::vector<int>& indices);

}  // namespace facenav::registration
