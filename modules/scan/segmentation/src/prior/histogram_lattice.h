#pragma once
// Histograms of a scan's values on a lattice of places: the intensities of one class of tissue near each
// place.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "facenav/core/robust_statistics.h"
#include "facenav/volume/volume.h"

namespace facenav::segmentation {

constexpr int kHistogramBins = 32;
constexpr float kPseudoVoxels = 4;  // pseudo-count per bin, against chance
constexpr float kMostRatio = 3;     // limit of a log likelihood ratio
using Histogram = std::array<float, kHistogramBins>;

/// Smooths neighbouring bins by 1-2-1.
inline Histogram smoothedBins(const Histogram& h) {
  Histogram out;
  for (int b = 0; b < kHistogramBins; ++b)
    out[b] = 0.5f * h[b] + 0.25f * (h[std::max(0, b - 1)] + h[std::min(kHistogramBins - 1, b + 1)]);
  return out;
}

class HistogramLattice {
 public:
  HistogramLattice(const volume::VoxelGrid& grid, double step_mm)
      : per_voxel_(float(grid.spacing_mm().mean() / step_mm)) {
    for (int a = 0; a < 3; ++a) size_[a] = int(float(grid.size[a]) * per_voxel_) + 2;
    nodes_.resize(std::size_t(size_[0]) * size_[1] * size_[2]);
  }
  /// Calls visit(node, weight) for the eight nodes about the voxel.
  template <class Visit>
  void forNodes(int i, int j, int k, Visit&& visit) const {
    const float x = float(i) * per_voxel_, y = float(j) * per_voxel_, z = float(k) * per_voxel_;
    const int a = int(x), b = int(y), c = int(z);
    const float u = x - float(a), v = y - float(b), w = z - float(c);
    for (int n = 0; n < 8; ++n)
      visit(index(a + n % 2, b + n / 2 % 2, c + n / 4),
            (n % 2 ? u : 1 - u) * (n / 2 % 2 ? v : 1 - v) * (n / 4 ? w : 1 - w));
  }
  Histogram& operator[](std::size_t node) { return nodes_[node]; }
  const Histogram& operator[](std::size_t node) const { return nodes_[node]; }
  std::size_t count() const { return nodes_.size(); }
  /// Smooths by 1-2-1 along each axis.
  void smooth() {
    const std::array<std::size_t, 3> stride{1, std::size_t(size_[0]), std::size_t(size_[0]) * size_[1]};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto before = nodes_;
      for (std::size_t n = 0; n < nodes_.size(); ++n) {
        const int at = int(n / stride[axis]) % size_[axis];
        const Histogram& low = before[at > 0 ? n - stride[axis] : n];
        const Histogram& high = before[at + 1 < size_[axis] ? n + stride[axis] : n];
        for (int b = 0; b < kHistogramBins; ++b)
          nodes_[n][b] = 0.5f * before[n][b] + 0.25f * (low[b] + high[b]);
      }
    }
  }

 private:
  std::size_t index(int i, int j, int k) const {
    return std::size_t(i) + std::size_t(size_[0]) * (std::size_t(j) + std::size_t(size_[1]) * k);
  }
  std::array<int, 3> size_{};
  float per_voxel_;
  std::vector<Histogram> nodes_;
};

struct HistogramBins {
  float low = 0, per_value = 0;
  int of(float value) const { return std::clamp(int((value - low) * per_value), 0, kHistogramBins - 1); }
};

/// Bins from the dark to the bright end of the values nearer to the outline than `reach_mm`.
inline HistogramBins binsOf(const volume::Volume& image, const std::vector<float>& depth_mm, float reach_mm) {
  constexpr double kDark = 0.01, kBright = 0.99;  // shares of the values
  std::vector<float> values;
  for (std::size_t v = 0; v < image.voxels.size(); v += 3)
    if (std::abs(depth_mm[v]) < reach_mm) values.push_back(image.voxels[v]);
  if (values.empty()) return {};
  const float low = selectRank(values, std::size_t(kDark * double(values.size() - 1)));
  const float high = selectRank(values, std::size_t(kBright * double(values.size() - 1)));
  return {low, high > low ? float(kHistogramBins) / (high - low) : 0.f};
}

/// Calls visit(voxel, i, j) for the voxels of slice `k`.
template <class Visit>
void forVoxelsOf(const volume::VoxelGrid& grid, int k, Visit&& visit) {
  std::size_t v = grid.index(0, 0, k);
  for (int j = 0; j < grid.size[1]; ++j)
    for (int i = 0; i < grid.size[0]; ++i, ++v) visit(v, i, j);
}

}  // namespace facenav::segmentation
