#include "prior/tissue_mixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "brain_start.h"
#include "facenav/volume/regrid.h"
#include "head_phantom.h"
#include "prior/averaged_prior.h"
#include "prior/local_evidence.h"
#include "prior/prior_refinement.h"
#include "prior/stated_doubt.h"

// Fitting the prior's outline to a scan that is no clear T1: classes by local histograms, and the average
// over several views.

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

constexpr int kSide = 60;
constexpr int kTissueTop = 30, kPriorTop = 34, kFluidTop = 40;  // the prior's outline lies 4 mm too far out

/// Tissue below, then fluid, then the rest; in the tissue a sulcus of 6 mm that the prior does not contain.
struct Layers {
  Volume image;
  TissueShares shares;
  std::vector<float> depth_mm;
};

bool isSulcus(int i, int k) { return i >= 27 && i < 33 && k >= 24 && k < kTissueTop; }

Layers makeLayers(float tissue, float fluid, float rest) {
  std::mt19937 random(5);
  std::normal_distribution<float> noise(0, 2);
  Layers made;
  made.image.grid.size = {kSide, kSide, kSide};
  made.shares.brain.grid = made.shares.fluid.grid = made.image.grid;
  Mask outline{made.image.grid, {}};
  for (int k = 0; k < kSide; ++k)
    for (int j = 0; j < kSide; ++j)
      for (int i = 0; i < kSide; ++i) {
        const bool is_fluid = isSulcus(i, k) || (k >= kTissueTop && k < kFluidTop);
        made.image.voxels.push_back((is_fluid ? fluid : k < kTissueTop ? tissue : rest) + noise(random));
        const float brain = 1 / (1 + std::exp(0.5f * float(k - kPriorTop)));
        made.shares.brain.voxels.push_back(brain);
        made.shares.fluid.voxels.push_back((1 - brain) / (1 + std::exp(0.5f * float(k - kFluidTop))));
        outline.voxels.push_back(brain >= 0.5f);
      }
  made.depth_mm = depthBelow(outline);
  return made;
}

std::vector<float> logOddsIn(const Layers& layers) {
  return tissueLogOdds(layers.image, layers.shares, layers.depth_mm, PriorUse());
}

/// Share of tissue among the voxels at height `k`, beside the sulcus or in it.
double tissueShareAt(const Layers& layers, const std::vector<float>& log_odds, int k, bool in_sulcus) {
  double count = 0, tissue = 0;
  for (int j = 10; j < kSide - 10; ++j)
    for (int i = 10; i < kSide - 10; ++i) {
      if (in_sulcus != (i >= 29 && i < 31) || (!in_sulcus && i > 22 && i < 38)) continue;
      ++count, tissue += log_odds[layers.image.grid.index(i, j, k)] > 0;
    }
  return tissue / count;
}

TEST(TissueMixture, MovesTheOutlineToTheTissueAndOpensAWideSulcus) {
  const Layers layers = makeLayers(100, 30, 160);
  const auto log_odds = logOddsIn(layers);
  EXPECT_GT(tissueShareAt(layers, log_odds, kTissueTop - 3, false), 0.99);
  EXPECT_LT(tissueShareAt(layers, log_odds, kTissueTop + 2, false), 0.01);
  EXPECT_LT(tissueShareAt(layers, log_odds, kTissueTop - 3, true), 0.05);
}

TEST(TissueMixture, NeedsNoCertainOrderOfBrightness) {
  const Layers layers = makeLayers(60, 140, 20);
  const auto log_odds = logOddsIn(layers);
  EXPECT_GT(tissueShareAt(layers, log_odds, kTissueTop - 3, false), 0.99);
  EXPECT_LT(tissueShareAt(layers, log_odds, kTissueTop + 2, false), 0.01);
}

TEST(TissueMixture, KeepsThePriorWhereIntensitiesAreAlike) {
  const Layers layers = makeLayers(80, 80, 80);
  const auto log_odds = logOddsIn(layers);
  EXPECT_GT(tissueShareAt(layers, log_odds, kPriorTop - 3, false), 0.9);
  EXPECT_LT(tissueShareAt(layers, log_odds, kPriorTop + 3, false), 0.1);
}

TEST(TissueMixture, DoesNotFailOnAnImageOfOneValue) {
  Layers layers = makeLayers(80, 80, 80);
  for (float& v : layers.image.voxels) v = 7;
  for (const float v : logOddsIn(layers)) ASSERT_TRUE(std::isfinite(v));
}

TEST(LogOdds, AreLimited) {
  EXPECT_FLOAT_EQ(logOddsOf(0.5f), 0);
  EXPECT_FLOAT_EQ(logOddsOf(1), 6);
  EXPECT_FLOAT_EQ(logOddsOf(0), -6);
}

std::vector<BoundaryDoubt> placesWith(const std::vector<float>& scores) {
  std::vector<BoundaryDoubt> places;
  for (const float score : scores) places.push_back({Point<Mri>(0, 0, 0), score});
  return places;
}

TEST(StatedDoubt, RisesWithTheScoreAndStaysWithinItsLimits) {
  for (const auto kind : {ContrastKind::t1, ContrastKind::weak_t1, ContrastKind::t2, ContrastKind::flair,
                          ContrastKind::proton_density}) {
    auto places = placesWith({-5, 0.2f, 0.4f, 0.6f, 0.8f, 1, 1.3f, 1.6f, 2, 40});
    stateDoubts(places, kind);
    for (std::size_t n = 1; n < places.size(); ++n)
      EXPECT_GE(places[n].doubt_mm, places[n - 1].doubt_mm) << int(kind);
    EXPECT_GT(places[7].doubt_mm, places[3].doubt_mm) << int(kind);
    EXPECT_FLOAT_EQ(places.front().doubt_mm, 0.2f);
    EXPECT_FLOAT_EQ(places.back().doubt_mm, 8);
  }
  std::vector<BoundaryDoubt> none;
  stateDoubts(none, ContrastKind::t2);
  EXPECT_TRUE(none.empty());
}

TEST(StatedDoubt, GivesTheFittedMillimetresAtTheMapsScores) {
  // The median is the usual one of T2, so that nothing is shifted.
  auto places = placesWith({0.1f, 0.3f, 0.516f, 0.681f, 1.217f});
  stateDoubts(places, ContrastKind::t2);
  EXPECT_NEAR(places[3].doubt_mm, 1, 1e-4);
  EXPECT_NEAR(places[4].doubt_mm, 3, 1e-4);
}

TEST(StatedDoubt, AScanOfHigherScoresIsStatedALittleWorse) {
  const std::vector<float> usual{0.4f, 0.5f, 0.633f, 0.9f, 1.3f};
  std::vector<float> high = usual;
  for (float& score : high) score += 0.4f;
  auto places = placesWith(usual), higher = placesWith(high);
  stateDoubts(places, ContrastKind::proton_density), stateDoubts(higher, ContrastKind::proton_density);
  for (std::size_t n = 0; n < usual.size(); ++n) {
    EXPECT_GT(higher[n].doubt_mm, places[n].doubt_mm);
    EXPECT_LT(higher[n].doubt_mm, places[n].doubt_mm + 1);
  }
}

TEST(RaiseDoubts, APlaceBeyondTheOthersGridIsDoubtedByItsDistance) {
  volume::Mask other;  // a cube of 10 mm in a grid of 40 mm
  other.grid.size = {40, 40, 40};
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 40; ++i)
        other.voxels.push_back(std::min({i, j, k}) >= 15 && std::max({i, j, k}) < 25);
  std::vector<BoundaryDoubt> doubts{{Point<Mri>(15, 20, 20), 1},  // on the outline
                                    {Point<Mri>(5, 20, 20), 1},   // 10 mm beside it
                                    {Point<Mri>(59, 20, 20), 1},  // 20 mm beyond the grid
                                    {Point<Mri>(40, 20, 20), 1},  // 1 mm beyond, 15 mm from the outline there
                                    {Point<Mri>(59, 20, 20), 30}};
  raiseDoubts(doubts, other);
  const float expected_mm[] = {1, 10, 20, 14, 30};
  for (std::size_t n = 0; n < doubts.size(); ++n)
    EXPECT_NEAR(doubts[n].doubt_mm, expected_mm[n], 1e-3) << "place " << n;
}

TEST(DoubtScore, RisesWithAllItsEvidence) {
  const PlaceEvidence evidence{4, 1, 2};
  const float score = doubtScore(evidence);
  EXPECT_NEAR(score, 0.054 * 4 + 0.031 + 0.151 * 2, 1e-5);
  EXPECT_GT(doubtScore({5, 1, 2}), score);
  EXPECT_GT(doubtScore({4, 2, 2}), score);
  EXPECT_GT(doubtScore({4, 1, 3}), score);
  EXPECT_FLOAT_EQ(doubtScore({4, 1, 20}), doubtScore({4, 1, 500}));
}

TEST(IntensityCurve, LeavesAirDark) {
  Volume window;
  window.grid.size = {5, 1, 1};
  window.voxels = {-0.1f, 0.02f, 0.1f, 0.5f, 1.f};
  const Volume inverted = withCurve(window, IntensityCurve::inverted);
  EXPECT_FLOAT_EQ(inverted.voxels[0], 0);
  EXPECT_FLOAT_EQ(inverted.voxels[1], 0.02f);
  EXPECT_NEAR(inverted.voxels[2], 0.96, 1e-5);
  EXPECT_NEAR(inverted.voxels[4], 0.06, 1e-5);
  EXPECT_GT(withCurve(window, IntensityCurve::brighter).voxels[3], 0.6f);
  EXPECT_LT(withCurve(window, IntensityCurve::darker).voxels[3], 0.35f);
  EXPECT_FLOAT_EQ(withCurve(window, IntensityCurve::darker).voxels[4], 1);
}

TEST(AveragedPrior, FindsThePhantomsBrainInANegativeToo) {
  ASSERT_TRUE(installedPrior().network) << installedPrior().fault;
  const auto phantom = testing::makeHeadPhantom();
  Volume negative = phantom.volume;
  for (float& v : negative.voxels) v = v < 10 ? v : 160 - v;
  const Volume working = workingVolume(negative, 1.0);
  const auto prior = findBrainPrior(*installedPrior().network, working);
  ASSERT_TRUE(prior);
  const BrainPrior averaged = averagedPrior(*installedPrior().network, working, *prior);
  for (const float share : averaged.brain.voxels) ASSERT_TRUE(share >= 0 && share <= 1.0001f) << share;
  EXPECT_NE(averaged.brain.voxels, prior->brain.voxels);
  EXPECT_EQ(averaged.fluid.voxels, prior->fluid.voxels);
  const RefinedPrior refined = refinedByTissue(working, averaged, PriorUse());
  EXPECT_GT(volume::overlap(volume::resample(refined.mask, phantom.brain.grid), phantom.brain).dice, 0.9);
  EXPECT_FALSE(refined.doubts.empty());
}

}  // namespace
}  // namespace facenav::segmentation
