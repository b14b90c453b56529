#pragma once
// Thins the face cloud to an even density, so that near and well lit skin does not dominate.

#include <vector>

#include "facenav/geometry/point.h"

namespace facenav::registration {

/// Indices of at most `most` finite points, one per cube of `cell_mm` (the first of it in a scattered order).
/// The cubes are enlarged until the number fits.
std::vector<int> thinOut(const PointCloud<Camera>& cloud, double cell_mm, std::size_t most);

/// Thins the points with indices `of` in the same way.
std::vector<int> thinOut(const PointCloud<Camera>& cloud, const std::vector<int>& of, double cell_mm,
                         std::size_t most);

/// At most `most` of the points, at equal steps of the list. Denser regions stay denser.
std::vector<int> someOf(std::vector<int> points, std::size_t most);

/// Indices of the points with finite coordinates within 100 m.
std::vector<int> finitePoints(const PointCloud<Camera>& cloud);

/// The points picked by `indices`.
PointCloud<Camera> pick(const PointCloud<Camera>& cloud, const std::vector<int>& indices);

}  // namespace facenav::registration
