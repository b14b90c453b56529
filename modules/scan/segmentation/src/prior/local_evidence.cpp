#include "prior/local_evidence.h"

#include <algorithm>
#include <cmath>

#include "facenav/volume/for_slices.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/smoothing.h"
#include "prior/histogram_lattice.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

constexpr float kSure_mm = 0.5f;  // voxels nearer to the outline than this are samples of neither side

/// Replaces `inside` by the log ratio of the two sides.
void compare(HistogramLattice& inside, const HistogramLattice& outside) {
  for (std::size_t n = 0; n < inside.count(); ++n) {
    const Histogram in = smoothedBins(inside[n]), out = smoothedBins(outside[n]);
    float ins = kPseudoVoxels * kHistogramBins, outs = ins;
    for (int b = 0; b < kHistogramBins; ++b) ins += in[b], outs += out[b];
    for (int b = 0; b < kHistogramBins; ++b)
      inside[n][b] = std::clamp(std::log((in[b] + kPseudoVoxels) / ins * outs / (out[b] + kPseudoVoxels)),
                                -kMostRatio, kMostRatio);
  }
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
  const HistogramBins bins = binsOf(image, depth_mm, reach_mm);
  HistogramLattice inside(image.grid, use.lattice_mm), outside(image.grid, use.lattice_mm);
  for (int k = 0; k < image.grid.size[2]; ++k)
    forVoxelsOf(image.grid, k, [&](std::size_t v, int i, int j) {
      const float depth = depth_mm[v];
      if (std::abs(depth) > reach_mm || std::abs(depth) < kSure_mm) return;
      const auto bin = std::size_t(bins.of(image.voxels[v]));
      HistogramLattice& side = depth > 0 ? inside : outside;
      side.forNodes(i, j, k, [&](std::size_t node, float weight) { side[node][bin] += weight; });
    });
  for (int n = 0; n < use.lattice_smoothings; ++n) inside.smooth(), outside.smooth();
  compare(inside, outside);
  Volume evidence{image.grid, std::vector<float>(image.voxels.size()), {}, {}};
  volume::forSlices(image.grid.size[2], [&](int k) {
    forVoxelsOf(image.grid, k, [&](std::size_t v, int i, int j) {
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
