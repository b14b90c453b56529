#include "downhill_growth.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

constexpr int kLevels = 256;  // steps of 0.004 of the range, far below noise

/// The image in levels from 1; 0 where growth is forbidden. The grid's outermost voxels are 0, so that all
/// neighbours of the others lie in the grid.
std::vector<std::uint16_t> levelsOf(const Volume& image, const Mask& within, const DownhillRange& range) {
  std::vector<std::uint16_t> levels(image.voxels.size());
  const auto& n = image.grid.size;
  const float scale = (kLevels - 1) / (range.top - range.floor);
  for (int k = 1; k + 1 < n[2]; ++k)
    for (int j = 1; j + 1 < n[1]; ++j) {
      std::size_t v = image.grid.index(1, j, k);
      for (int i = 1; i + 1 < n[0]; ++i, ++v)
        if (within.voxels[v])
          levels[v] =
              std::uint16_t(1 + std::clamp((image.voxels[v] - range.floor) * scale, 0.f, float(kLevels - 1)));
    }
  return levels;
}

}  // namespace

Mask growDownhill(const Volume& image, const Mask& seed, const Mask& within, const DownhillRange& range) {
  const auto levels = levelsOf(image, within, range);
  std::vector<std::uint16_t> lowest(levels.size());  // on the best path; 0: not reached
  std::array<std::vector<std::uint32_t>, kLevels + 1> front;
  const auto reach = [&](std::size_t v, std::uint16_t level) {
    if (level > lowest[v]) lowest[v] = level, front[level].push_back(std::uint32_t(v));
  };
  for (std::size_t v = 0; v < levels.size(); ++v)
    if (seed.voxels[v]) reach(v, levels[v]);
  const std::size_t row = image.grid.size[0], slab = row * image.grid.size[1];
  const int rise = int(range.rise * (kLevels - 1));
  // Processes the highest level first: a path's lowest value only falls, so each voxel is final when its
  // level is processed.
  for (int level = kLevels; level > 0; --level)
    for (std::size_t at = 0; at < front[level].size(); ++at) {
      const std::size_t v = front[level][at];
      if (lowest[v] != level) continue;
      for (const std::size_t next : {v - 1, v + 1, v - row, v + row, v - slab, v + slab})
        if (levels[next] <= level + rise)
          reach(next, std::min<std::uint16_t>(levels[next], std::uint16_t(level)));
    }
  Mask grown{image.grid, std::vector<std::uint8_t>(levels.size())};
  for (std::size_t v = 0; v < levels.size(); ++v) grown.voxels[v] = lowest[v] > 0;
  return grown;
}

}  // namespace facenav::segmentation
