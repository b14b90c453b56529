#include "facenav/volume/local_mean.h"

#include <algorithm>
#include <cmath>

namespace facenav::volume {
namespace {

constexpr float kLeastWeight = 1e-3f;  // of the voxels about a place

/// Running mean over 2 * half + 1 voxels along one line, fewer at its ends.
void boxAlong(float* line, std::size_t stride, int n, int half, std::vector<double>& sums) {
  sums.assign(std::size_t(n) + 1, 0);
  for (int i = 0; i < n; ++i) sums[i + 1] = sums[i] + line[i * stride];
  for (int i = 0; i < n; ++i) {
    const int begin = std::max(0, i - half), end = std::min(n, i + half + 1);
    line[i * stride] = float((sums[end] - sums[begin]) / (end - begin));
  }
}

void blurredInPlace(const VoxelGrid& grid, std::vector<float>& values, double reach_mm) {
  const auto& n = grid.size;
  const std::size_t stride[3] = {1, std::size_t(n[0]), std::size_t(n[0]) * n[1]};
  std::vector<double> sums;
  for (int axis = 0; axis < 3; ++axis) {
    const int half = std::max(1, int(std::lround(0.5 * reach_mm / grid.spacing_mm()[axis])));
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (int u = 0; u < n[a]; ++u)
      for (int v = 0; v < n[b]; ++v)
        for (int pass = 0; pass < 3; ++pass)
          boxAlong(&values[u * stride[a] + v * stride[b]], stride[axis], n[axis], half, sums);
  }
}

}  // namespace

std::vector<float> localMean(const VoxelGrid& grid, const std::vector<float>& values,
                             const std::vector<std::uint8_t>& counts, double reach_mm, float otherwise) {
  std::vector<float> sum(values.size()), weight(values.size());
  for (std::size_t v = 0; v < values.size(); ++v)
    if (counts[v]) sum[v] = values[v], weight[v] = 1;
  blurredInPlace(grid, sum, reach_mm);
  blurredInPlace(grid, weight, reach_mm);
  for (std::size_t v = 0; v < sum.size(); ++v)
    sum[v] = weight[v] > kLeastWeight ? sum[v] / weight[v] : otherwise;
  return sum;
}

}  // namespace facenav::volume
