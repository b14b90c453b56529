#include "facenav/editing/region_grow.h"

#include <array>

#include "facenav/core/error.h"
#include "voxel_box.h"

namespace facenav::editing {
namespace {

Eigen::Array3i voxelAt(const volume::VoxelGrid& grid, const Point<Mri>& place) {
  return grid.toVoxel(place).array().round().cast<int>();
}

/// A part of the grid with its own visited flags.
struct Neighbourhood {
  Neighbourhood(const volume::VoxelGrid& grid, const VoxelBox& box)
      : grid_(grid), box_(box), extent_(box.high - box.low + 1) {
    seen_.assign(std::size_t(extent_[0]) * extent_[1] * extent_[2], 0);
  }
  bool visit(const Eigen::Array3i& at) {
    if ((at < box_.low).any() || (at > box_.high).any()) return false;
    const Eigen::Array3i p = at - box_.low;
    auto& mark = seen_[p[0] + std::size_t(extent_[0]) * (p[1] + std::size_t(extent_[1]) * p[2])];
    return mark ? false : (mark = 1);
  }
  const volume::VoxelGrid& grid_;
  VoxelBox box_;
  Eigen::Array3i extent_;
  std::vector<std::uint8_t> seen_;
};

}  // namespace

ValueRange rangeAround(const volume::Volume& volume, const Point<Mri>& place, double spread) {
  const Eigen::Array3i at = voxelAt(volume.grid, place);
  double sum = 0, squares = 0;
  int count = 0;
  for (int n = 0; n < 27; ++n) {
    const Eigen::Array3i p = at + Eigen::Array3i(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
    if (!volume.grid.contains(p[0], p[1], p[2])) continue;
    const double value = volume.at(p[0], p[1], p[2]);
    sum += value, squares += value * value, ++count;
  }
  if (count == 0) throw Error("the place lies outside the scan", {}, "click inside it");
  const double mean = sum / count, deviation = std::sqrt(std::max(0.0, squares / count - mean * mean));
  return {float(mean - spread * deviation), float(mean + spread * deviation)};
}

MaskChange growRegion(const volume::Mask& mask, const volume::Volume& volume, const Point<Mri>& seed,
                      const ValueRange& range, double reach_mm, bool is_brain) {
  MaskChange change;
  const auto& grid = volume.grid;
  const Eigen::Array3i start = voxelAt(grid, seed);
  if (!grid.contains(start[0], start[1], start[2]) ||
      !range.contains(volume.at(start[0], start[1], start[2])))
    return change;
  Neighbourhood near(grid, boxAround(grid, Eigen::AlignedBox3d(seed.mm), reach_mm));
  std::vector<Eigen::Array3i> front;
  const auto reach = [&](const Eigen::Array3i& at) {
    if (!near.visit(at)) return;
    const std::size_t v = grid.index(at[0], at[1], at[2]);
    if (!range.contains(volume.voxels[v])) return;
    if ((grid.mri_from_voxel * at.matrix().cast<double>() - seed.mm).squaredNorm() > reach_mm * reach_mm)
      return;
    if ((mask.voxels[v] != 0) != is_brain) change.voxels.push_back(std::uint32_t(v));
    front.push_back(at);
  };
  reach(start);
  while (!front.empty()) {
    const Eigen::Array3i at = front.back();
    front.pop_back();
    for (int a = 0; a < 3; ++a)
      for (int step : {-1, 1}) {
        Eigen::Array3i next = at;
        next[a] += step;
        reach(next);
      }
  }
  return change;
}

}  // namespace facenav::editing
