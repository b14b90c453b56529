#include "masked_air.h"

#include <algorithm>
#include <array>
#include <vector>

#include "facenav/core/robust_statistics.h"

namespace facenav::surface {
namespace {

/// The value that more than half of the voxels outside the head have exactly.
std::optional<float> commonAir(const volume::Volume& scan, const volume::Mask& head) {
  std::vector<float> outside;
  for (std::size_t v = 0; v < scan.voxels.size(); v += 7)  // a prime: favours no axis
    if (!head.voxels[v]) outside.push_back(scan.voxels[v]);
  if (outside.empty()) return {};
  // A value that more than half of them have is the median.
  const float air = selectRank(outside, outside.size() / 2);
  const auto same = std::count(outside.begin(), outside.end(), air);
  return 2 * std::size_t(same) > outside.size() ? std::optional<float>(air) : std::nullopt;
}

/// Values brighter than air, of voxels that share a face with air.
std::vector<float> besideAir(const volume::Volume& scan, float air) {
  std::vector<float> values;
  const auto& size = scan.grid.size;
  const std::array<std::size_t, 3> stride{1, std::size_t(size[0]), std::size_t(size[0]) * size[1]};
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        const std::array<int, 3> at{i, j, k};
        const std::size_t v = scan.grid.index(i, j, k);
        if (!(scan.voxels[v] > air)) continue;
        for (std::size_t a = 0; a < 3; ++a)
          if ((at[a] > 0 && scan.voxels[v - stride[a]] == air) ||
              (at[a] + 1 < size[a] && scan.voxels[v + stride[a]] == air)) {
            values.push_back(scan.voxels[v]);
            break;
          }
      }
  return values;
}

}  // namespace

std::optional<volume::Volume> withoutMaskStep(const volume::Volume& scan, const volume::Mask& head) {
  const auto air = commonAir(scan, head);
  if (!air) return {};
  std::vector<float> beside = besideAir(scan, *air);
  if (beside.size() < 100) return {};
  // Nearly the least of them, because a few voxels inside the head may be darker than the threshold.
  const float low = selectRank(beside, beside.size() / 10);
  volume::Volume raised = scan;
  for (float& value : raised.voxels) value = std::max(value, low);
  return raised;
}

}  // namespace facenav::surface
