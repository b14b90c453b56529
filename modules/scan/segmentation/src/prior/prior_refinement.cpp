#include "prior/prior_refinement.h"

#include <algorithm>
#include <cmath>

#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/regrid.h"
#include "facenav/volume/smoothing.h"
#include "prior/local_evidence.h"
#include "prior/stated_doubt.h"
#include "prior/tissue_mixture.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

constexpr double kMargin_mm = 14;

Mask whole(const Mask& brain, const PriorUse& use) {
  const Mask closed = fillHoles(close(brain, use.sulcus_mm));
  return largestPart(open(closed, use.smooth_mm));
}

constexpr int kDoubtStep = 2;  // voxels between the places where doubt is given

/// Distance of each voxel to the surface of the region at or above `level`.
std::vector<float> awayFrom(const std::vector<float>& values, float level, const volume::VoxelGrid& grid) {
  Mask mask{grid, std::vector<std::uint8_t>(values.size())};
  for (std::size_t v = 0; v < mask.voxels.size(); ++v) mask.voxels[v] = values[v] >= level;
  return volume::distanceTo(volume::surfaceVoxels(volume::largestPart(mask)));
}

std::vector<float> sumOf(std::vector<float> a, const std::vector<float>& b) {
  for (std::size_t v = 0; v < a.size(); ++v) a[v] += b[v];
  return a;
}

/// Distance between the levels 0.25 and 0.75 of the prior.
std::vector<float> priorWidth_mm(const Volume& probability) {
  return sumOf(awayFrom(probability.voxels, 0.25f, probability.grid),
               awayFrom(probability.voxels, 0.75f, probability.grid));
}

/// Calls `doubt_at(v)` for every other voxel of the surface.
template <class DoubtAt>
std::vector<BoundaryDoubt> doubtsOver(const Mask& mask, DoubtAt&& doubt_at) {
  const Mask surface = volume::surfaceVoxels(mask);
  std::vector<BoundaryDoubt> doubts;
  std::size_t v = 0;
  for (int k = 0; k < surface.grid.size[2]; ++k)
    for (int j = 0; j < surface.grid.size[1]; ++j)
      for (int i = 0; i < surface.grid.size[0]; ++i, ++v)
        if (surface.voxels[v] && (i + j + k) % kDoubtStep == 0)
          doubts.push_back({surface.grid.toMri({double(i), double(j), double(k)}), doubt_at(v)});
  return doubts;
}

/// Doubts by the width of the prior's edge, and the distance by which the scan moved its outline.
std::vector<BoundaryDoubt> doubtsOf(const RefinedPrior& refined, const Volume& probability,
                                    const PriorUse& use) {
  const std::vector<float> moved_mm = volume::distanceTo(volume::surfaceVoxels(refined.outline));
  const std::vector<float> width_mm = priorWidth_mm(probability);
  return doubtsOver(refined.mask, [&](std::size_t v) {
    return float(use.doubt_base_mm + use.doubt_width * width_mm[v] + use.doubt_moved * moved_mm[v]);
  });
}

/// Doubt scores (stated_doubt.h). `log_odds`: outside the fit's reach, that of the outline.
std::vector<BoundaryDoubt> scoresOf(const RefinedPrior& refined, const Volume& probability,
                                    const std::vector<float>& log_odds) {
  const std::vector<float> moved_mm = volume::distanceTo(volume::surfaceVoxels(refined.outline));
  const std::vector<float> width_mm = priorWidth_mm(probability);
  const std::vector<float> fit_mm =
      sumOf(awayFrom(log_odds, -1, probability.grid), awayFrom(log_odds, 1, probability.grid));
  return doubtsOver(refined.mask, [&](std::size_t v) {
    return doubtScore({width_mm[v], moved_mm[v], fit_mm[v]});
  });
}

/// Grid, outline and shares at the start of every refinement.
struct Beginning {
  Volume probability;
  Mask outline;
};

Beginning beginningOf(const Volume& working, const BrainPrior& prior) {
  const volume::VoxelGrid grid =
      volume::gridAround(prior.mask(), working.grid.spacing_mm().mean(), kMargin_mm);
  Beginning begun{volume::resample(prior.brain, grid), {grid, std::vector<std::uint8_t>(grid.count())}};
  for (std::size_t v = 0; v < grid.count(); ++v)
    begun.outline.voxels[v] = begun.probability.voxels[v] >= 0.5f;
  begun.outline = fillHoles(largestPart(begun.outline));
  return begun;
}

}  // namespace

namespace {

/// Moves the outline of `begun` within the band.
Mask movedOutline(const Volume& working, const Beginning& begun, const PriorUse& use) {
  const Volume& probability = begun.probability;
  const Volume image = volume::smoothed(volume::resample(working, probability.grid));
  const std::vector<float> from_outline = depthBelow(begun.outline);
  Mask moved = begun.outline;
  for (int round = 0; round < use.rounds; ++round) {
    const Volume evidence = localEvidence(image, round ? depthBelow(moved) : from_outline, use);
    Mask next = begun.outline;
    for (std::size_t v = 0; v < next.voxels.size(); ++v)
      if (std::abs(from_outline[v]) < use.band_mm)
        next.voxels[v] = logOddsOf(probability.voxels[v]) + float(use.evidence) * evidence.voxels[v] > 0;
    moved = whole(next, use);
  }
  return moved;
}

}  // namespace

Mask refinedMask(const Volume& working, const BrainPrior& prior, const PriorUse& use) {
  return movedOutline(working, beginningOf(working, prior), use);
}

RefinedPrior refinedPrior(const Volume& working, const BrainPrior& prior, const PriorUse& use) {
  Beginning begun = beginningOf(working, prior);
  Mask moved = movedOutline(working, begun, use);
  RefinedPrior refined{std::move(begun.outline), std::move(moved), {}};
  refined.doubts = doubtsOf(refined, begun.probability, use);
  return refined;
}

RefinedPrior refinedByTissue(const Volume& working, const BrainPrior& prior, const PriorUse& use) {
  Beginning begun = beginningOf(working, prior);
  const std::vector<float> from_outline = depthBelow(begun.outline);
  const volume::VoxelGrid& grid = begun.outline.grid;
  const TissueShares shares{std::move(begun.probability), volume::resample(prior.fluid, grid)};
  std::vector<float> log_odds = tissueLogOdds(volume::resample(working, grid), shares, from_outline, use);
  RefinedPrior refined{begun.outline, begun.outline, {}};
  for (std::size_t v = 0; v < log_odds.size(); ++v) {
    if (std::abs(from_outline[v]) < use.other_reach_mm)
      refined.mask.voxels[v] = log_odds[v] > 0;
    else
      log_odds[v] = refined.outline.voxels[v] ? kMostLogOdds : -kMostLogOdds;
  }
  refined.mask = whole(refined.mask, use);
  refined.doubts = scoresOf(refined, shares.brain, log_odds);
  return refined;
}

}  // namespace facenav::segmentation
