#include "prior/tissue_mixture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "facenav/volume/for_slices.h"
#include "facenav/volume/smoothing.h"
#include "prior/histogram_lattice.h"

namespace facenav::segmentation {
namespace {

using volume::Volume;

constexpr int kLatticeSmoothings = 2, kRatioSmoothings = 1;
// Least shares of the two other classes: open sulci deep in the prior's outline contain fluid, but nothing
// else but brain. Chosen by judgement.
constexpr float kLeastFluid = 0.1f, kLeastOther = 0.002f;

struct Shares3 {
  float brain, fluid, other;
};

/// Squares and normalises the shares: a voxel of which the network is uncertain contributes little to a
/// class's intensities.
Shares3 sharpened(const Shares3& s) {
  const float b = s.brain * s.brain, f = s.fluid * s.fluid, o = s.other * s.other, sum = b + f + o + 1e-8f;
  return {b / sum, f / sum, o / sum};
}

void makeLogarithms(HistogramLattice& lattice) {
  for (int n = 0; n < kLatticeSmoothings; ++n) lattice.smooth();
  for (std::size_t n = 0; n < lattice.count(); ++n) {
    Histogram h = smoothedBins(lattice[n]);
    float sum = kPseudoVoxels * kHistogramBins;
    for (const float count : h) sum += count;
    for (float& count : h) count = std::log((count + kPseudoVoxels) / sum);
    lattice[n] = h;
  }
}

class TissueMixture {
 public:
  TissueMixture(const Volume& image, const TissueShares& shares, const std::vector<float>& depth_mm,
                const PriorUse& use)
      : image_(image),
        shares_(shares),
        depth_mm_(depth_mm),
        use_(use),
        bins_(binsOf(image, depth_mm, float(use.other_reach_mm))) {
    for (std::size_t v = 0; v < image.voxels.size(); ++v) now_.push_back(sharesAt(v));
    log_odds_.resize(image.voxels.size());
  }
  void round() {
    const Classes classes = histograms();
    Volume ratio{image_.grid, std::vector<float>(image_.voxels.size()), {}, {}};
    std::vector<float> fluid_of_rest(ratio.voxels.size());
    volume::forSlices(image_.grid.size[2], [&](int k) {
      forVoxelsOf(image_.grid, k, [&](std::size_t v, int i, int j) {
        if (isNear(v)) ratio.voxels[v] = logRatio(classes, v, {i, j, k}, fluid_of_rest[v]);
      });
    });
    for (int n = 0; n < kRatioSmoothings; ++n) ratio = volume::smoothed(std::move(ratio));
    for (std::size_t v = 0; v < log_odds_.size(); ++v) {
      const float prior = std::min(logOddsOf(shares_.brain.voxels[v]), float(use_.other_most_prior));
      log_odds_[v] = float(use_.other_prior) * prior +
                     (isNear(v) ? float(use_.other_evidence) * ratio.voxels[v] : 0.f) -
                     float(use_.other_inwards);
      const float brain = 1 / (1 + std::exp(-log_odds_[v]));
      now_[v] = {brain, (1 - brain) * fluid_of_rest[v], (1 - brain) * (1 - fluid_of_rest[v])};
    }
  }
  std::vector<float> logOdds() && { return std::move(log_odds_); }

 private:
  struct Classes {
    HistogramLattice brain, fluid, other;
  };
  Shares3 sharesAt(std::size_t v) const {
    const float brain = shares_.brain.voxels[v], fluid = std::min(shares_.fluid.voxels[v], 1 - brain);
    return {brain, fluid, 1 - brain - fluid};
  }
  bool isNear(std::size_t v) const { return std::abs(depth_mm_[v]) < float(use_.other_reach_mm); }
  Classes histograms() const {
    const HistogramLattice none(image_.grid, use_.other_lattice_mm);
    Classes classes{none, none, none};
    for (int k = 0; k < image_.grid.size[2]; ++k)
      forVoxelsOf(image_.grid, k, [&](std::size_t v, int i, int j) {
        if (!isNear(v)) return;
        const auto bin = std::size_t(bins_.of(image_.voxels[v]));
        const Shares3 s = sharpened(now_[v]);
        none.forNodes(i, j, k, [&](std::size_t node, float weight) {
          classes.brain[node][bin] += weight * s.brain;
          classes.fluid[node][bin] += weight * s.fluid;
          classes.other[node][bin] += weight * s.other;
        });
      });
    for (HistogramLattice* lattice : {&classes.brain, &classes.fluid, &classes.other})
      makeLogarithms(*lattice);
    return classes;
  }
  /// Log ratio of brain to the mixture of fluid and the rest.
  float logRatio(const Classes& classes, std::size_t v, std::array<int, 3> at, float& fluid_of_rest) const {
    const auto bin = std::size_t(bins_.of(image_.voxels[v]));
    Shares3 log{0, 0, 0};
    classes.brain.forNodes(at[0], at[1], at[2], [&](std::size_t node, float weight) {
      log.brain += weight * classes.brain[node][bin];
      log.fluid += weight * classes.fluid[node][bin];
      log.other += weight * classes.other[node][bin];
    });
    const Shares3 s = sharesAt(v);
    const float fluid = std::max(s.fluid, kLeastFluid), other = std::max(s.other, kLeastOther);
    const float by_fluid = fluid * std::exp(log.fluid), by_other = other * std::exp(log.other);
    fluid_of_rest = by_fluid / (by_fluid + by_other);
    return std::clamp(log.brain - std::log((by_fluid + by_other) / (fluid + other)), -kMostRatio, kMostRatio);
  }

  const Volume& image_;
  const TissueShares& shares_;
  const std::vector<float>& depth_mm_;
  PriorUse use_;
  HistogramBins bins_;
  std::vector<Shares3> now_;
  std::vector<float> log_odds_;
};

}  // namespace

float logOddsOf(float p) {
  return std::clamp(std::log((p + 1e-6f) / (1 - p + 1e-6f)), -kMostLogOdds, kMostLogOdds);
}

std::vector<float> tissueLogOdds(const Volume& image, const TissueShares& shares,
                                 const std::vector<float>& depth_mm, const PriorUse& use) {
  TissueMixture mixture(image, shares, depth_mm, use);
  for (int round = 0; round < use.other_rounds; ++round) mixture.round();
  return std::move(mixture).logOdds();
}

}  // namespace facenav::segmentation
