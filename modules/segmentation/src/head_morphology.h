#pragma once
// Morphology on anisotropic grids by exact Euclidean distance (Felzenszwalb and Huttenlocher 2012), for the
// head mask. Beyond the grid lies "unknown": it neither dilates nor erodes.

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace facenav::segmentation {

/// 0/1 voxels, i fastest.
struct BitGrid {
  std::array<int, 3> size{0, 0, 0};
  Eigen::Vector3d spacing_mm{1, 1, 1};
  std::vector<std::uint8_t> voxels;

  std::size_t index(int i, int j, int k) const {
    return i + std::size_t(size[0]) * (j + std::size_t(size[1]) * k);
  }
};

/// Squared distance (mm^2) from each voxel to the nearest one with `value`; a huge number where there is
/// none.
std::vector<float> squaredDistance(const BitGrid& grid, std::uint8_t value);

BitGrid dilate(const BitGrid& grid, double radius_mm);
BitGrid erode(const BitGrid& grid, double radius_mm);
BitGrid close(const BitGrid& grid, double radius_mm);
BitGrid open(const BitGrid& grid, double radius_mm);

/// The largest 6-connected component.
BitGrid largestComponent(const BitGrid& grid);
/// What grows out of `seed` inside `limit`, at most `steps` voxels far.
BitGrid growInside(const BitGrid& seed, const BitGrid& limit, int steps);
/// Fills what the outside cannot reach. On each face of the grid what is enclosed in that face counts as
/// inside, so that an airway which leaves through the scan's lower end does not let the outside in.
BitGrid fillCavities(const BitGrid& grid);
/// Adds what sees the outside in at most `most_open` of the 26 grid directions: sinuses, nostrils, ear
/// canals, and the dark bone under a scalp whose face was cut off, however they open.
BitGrid fillOccluded(const BitGrid& grid, int most_open);

}  // namespace facenav::segmentation
