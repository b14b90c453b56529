#pragma once
// Thinning of the face cloud: even density, so that near and well lit skin counts no more than the rest.

#include <vector>

#include "facenav/geometry/point.h"

namespace facenav::registration {

/// Indices of at most `most` finite points, one per cube of `cell_mm` (the one first in a scattered order);
/// the cubes are enlarged until the number fits.
std::vector<int> thinOut(const PointCloud<Camera>& cloud, double cell_mm, std::size_t most);

/// The same among the points `of`.
std::vector<int> thinOut(const PointCloud<Camera>& cloud, const std::vector<int>& of, double cell_mm,
                         std::size_t most);

/// At most `most` of these, evenly chosen: what is dense stays denser.
std::vector<int> someOf(std::vector<int> points, std::size_t most);

/// Indices of the points whose coordinates are numbers within 100 m.
std::vector<int> finitePoints(const PointCloud<Camera>& cloud);

/// The points picked by `indices`.
PointCloud<Camera> pick(const PointCloud<Camera>& cloud, const std::vector<int>& indices);

}  // namespace facenav::registration
