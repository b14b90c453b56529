#include "facenav/volume/local_mean.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "facenav/volume/for_slices.h"

namespace facenav::volume {
namespace {

constexpr float kLeastWeight = 1e-3f;  // least weight of voxels near a place

constexpr int kLines = 16;  // lines processed side by side: a cache line of floats
constexpr int kPasses = 3;

/// Neighbouring lines of equal length, value by value: `values[q * kLines + line]`.
struct LineBlock {
  explicit LineBlock(int longest)
      : values(std::size_t(longest) * kLines), sums(std::size_t(longest + 1) * kLines) {}
  std::vector<float> values;
  std::vector<double> sums;

  /// Running mean over 2 * half + 1 values along each line, fewer at its ends.
  void box(int n, int half) {
    for (int i = 0; i < n; ++i)
      for (int l = 0; l < kLines; ++l)
        sums[std::size_t(i + 1) * kLines + l] =
            sums[std::size_t(i) * kLines + l] + values[std::size_t(i) * kLines + l];
    for (int i = 0; i < n; ++i) {
      const int begin = std::max(0, i - half), end = std::min(n, i + half + 1);
      const double *low = &sums[std::size_t(begin) * kLines], *high = &sums[std::size_t(end) * kLines];
      for (int l = 0; l < kLines; ++l)
        values[std::size_t(i) * kLines + l] = float((high[l] - low[l]) / (end - begin));
    }
  }
};

/// Blurs up to kLines lines of `n` values (distance `stride`) whose first values lie `apart` from each other.
void blurLines(float* first, std::size_t apart, int lines, std::size_t stride, int n, int half,
               LineBlock& block) {
  for (int q = 0; q < n; ++q)
    for (int l = 0; l < lines; ++l) block.values[std::size_t(q) * kLines + l] = first[l * apart + q * stride];
  for (int pass = 0; pass < kPasses; ++pass) block.box(n, half);
  for (int q = 0; q < n; ++q)
    for (int l = 0; l < lines; ++l) first[l * apart + q * stride] = block.values[std::size_t(q) * kLines + l];
}

void blurredInPlace(const VoxelGrid& grid, std::vector<float>& values, double reach_mm) {
  const auto& n = grid.size;
  const std::size_t row = n[0], slab = row * n[1];
  std::array<int, 3> half;
  for (int a = 0; a < 3; ++a) half[a] = std::max(1, int(std::lround(0.5 * reach_mm / grid.spacing_mm()[a])));
  const int longest = *std::max_element(n.begin(), n.end());
  forSlices(n[2], [&](int k) {
    LineBlock block(longest);
    float* slice = &values[k * slab];
    for (int j = 0; j < n[1]; j += kLines)
      blurLines(slice + j * row, row, std::min(kLines, n[1] - j), 1, n[0], half[0], block);
    for (int i = 0; i < n[0]; i += kLines)
      blurLines(slice + i, 1, std::min(kLines, n[0] - i), row, n[1], half[1], block);
  });
  forSlices(n[1], [&](int j) {
    LineBlock block(longest);
    for (int i = 0; i < n[0]; i += kLines)
      blurLines(&values[j * row + i], 1, std::min(kLines, n[0] - i), slab, n[2], half[2], block);
  });
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
