#include "prior/local_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "facenav/core/robust_statistics.h"
#include "facenav/volume/for_slices.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/smoothing.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

constexpr int kBins = 32;
constexpr double kDark = 0.01, kBright = 0.99;  // shares of the values near the outline
constexpr float kPseudoCount = 4;               // voxels a bin on either side, against chance
constexpr float kMostEvidence = 3;
constexpr float kSure_mm = 0.5f;  // nearer to the outline no voxel is a sample of either side

using Histogram = std::array<float, kBins>;

/// Histograms on a lattice over a grid.
class Lattice {
 public:
  Lattice(const volume::VoxelGrid& grid, double step_mm)
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
  /// 1-2-1 along each axis.
  void smooth() {
    const std::array<std::size_t, 3> stride{1, std::size_t(size_[0]), std::size_t(size_[0]) * size_[1]};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto before = nodes_;
      for (std::size_t n = 0; n < nodes_.size(); ++n) {
        const int at = int(n / stride[axis]) % size_[axis];
        const Histogram& low = before[at > 0 ? n - stride[axis] : n];
        const Histogram& high = before[at + 1 < size_[axis] ? n + stride[axis] : n];
        for (int b = 0; b < kBins; ++b) nodes_[n][b] = 0.5f * before[n][b] + 0.25f * (low[b] + high[b]);
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

struct Bins {
  float low = 0, per_value = 0;
  int of(float value) const { return std::clamp(int((value - low) * per_value), 0, kBins - 1); }
};

Bins binsOf(const Volume& image, const std::vector<float>& depth_mm, float reach_mm) {
  std::vector<float> values;
  for (std::size_t v = 0; v < image.voxels.size(); v += 3)
    if (std::abs(depth_mm[v]) < reach_mm) values.push_back(image.voxels[v]);
  if (values.empty()) return {};
  const float low = selectRank(values, std::size_t(kDark * double(values.size() - 1)));
  const float high = selectRank(values, std::size_t(kBright * double(values.size() - 1)));
  return {low, high > low ? float(kBins) / (high - low) : 0.f};
}

Histogram smoothedBins(const Histogram& h) {
  Histogram out;
  for (int b = 0; b < kBins; ++b)
    out[b] = 0.5f * h[b] + 0.25f * (h[std::max(0, b - 1)] + h[std::min(kBins - 1, b + 1)]);
  return out;
}

/// Log ratio of the two sides, in the place of the first.
void compare(Lattice& inside, const Lattice& outside) {
  for (std::size_t n = 0; n < inside.count(); ++n) {
    const Histogram in = smoothedBins(inside[n]), out = smoothedBins(outside[n]);
    float ins = kPseudoCount * kBins, outs = ins;
    for (int b = 0; b < kBins; ++b) ins += in[b], outs += out[b];
    for (int b = 0; b < kBins; ++b)
      inside[n][b] = std::clamp(std::log((in[b] + kPseudoCount) / ins * outs / (out[b] + kPseudoCount)),
                                -kMostEvidence, kMostEvidence);
  }
}

template <class Visit>
void forVoxels(const volume::VoxelGrid& grid, int k, Visit&& visit) {
  std::size_t v = grid.index(0, 0, k);
  for (int j = 0; j < grid.size[1]; ++j)
    for (int i = 0; i < grid.size[0]; ++i, ++v) visit(v, i, j);
}

}  // namespace

std::vector<float> depthBelow(const Mask& outline) {
  std::vector<float> depth_mm = volume::depthWithin(outline);
  const std::vector<float> away_mm = volume::distanceTo(outline);
  const float half = 0.5f * float(outline.grid.spacing_mm().mean());  // the outline lies between voxels
  for (std::size_t v = 0; v < depth_mm.size(); ++v)
    depth_mm[v] = outline.voxels[v] ? depth_mm[v] - half : half - away_mm[v];
  return depth_mm;
}

Volume localEvidence(const Volume& image, const std::vector<float>& depth_mm, const PriorUse& use) {
  const float reach_mm = float(use.sample_mm);
  const Bins bins = binsOf(image, depth_mm, reach_mm);
  Lattice inside(image.grid, use.lattice_mm), outside(image.grid, use.lattice_mm);
  for (int k = 0; k < image.grid.size[2]; ++k)
    forVoxels(image.grid, k, [&](std::size_t v, int i, int j) {
      const float depth = depth_mm[v];
      if (std::abs(depth) > reach_mm || std::abs(depth) < kSure_mm) return;
      const auto bin = std::size_t(bins.of(image.voxels[v]));
      Lattice& side = depth > 0 ? inside : outside;
      side.forNodes(i, j, k, [&](std::size_t node, float weight) { side[node][bin] += weight; });
    });
  for (int n = 0; n < use.lattice_smoothings; ++n) inside.smooth(), outside.smooth();
  compare(inside, outside);
  Volume evidence{image.grid, std::vector<float>(image.voxels.size()), {}, {}};
  volume::forSlices(image.grid.size[2], [&](int k) {
    forVoxels(image.grid, k, [&](std::size_t v, int i, int j) {
      if (std::abs(depth_mm[v]) > reach_mm) return;
      const auto bin = std::size_t(bins.of(image.voxels[v]));
      float sum = 0;
      inside.forNodes(i, j, k, [&](std::size_t node, float weight) { sum += weight * inside[node][bin]; });
      evidence.voxels[v] = sum;
    });
  });
  for (int n = 0; n < use.evidence_smoothings; ++n) evidence = volume::smoothed(std::move(evidence));
  return evidence;
}

}  // namespace facenav::segmentation
