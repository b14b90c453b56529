#include "prior/tissue_mixture.h"

#include <gtest/gtest.h>

#include <random>

#include "brain_start.h"
#include "facenav/volume/regrid.h"
#include "head_phantom.h"
#include "prior/averaged_prior.h"
#include "prior/local_evidence.h"
#include "prior/prior_refinement.h"
#include "prior/stated_doubt.h"

// What fits the prior's outline to a scan that is no clear T1: classes by local histograms, and the average
// over several views.

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

constexpr int kSide = 60;
constexpr int kTissueTop = 30, kPriorTop = 34, kFluidTop = 40;  // the prior's outline lies 4 mm too far out

/// Tissue below, then fluid, then the rest; in the tissue a sulcus of 6 mm that the prior does not know.
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

/// Share of the voxels at height `k`, beside the sulcus or in it, that are tissue.
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

TEST(StatedDoubt, RisesWithTheDoubtAndStaysBelowItsMost) {
  const PriorUse use;
  for (const auto kind : {ContrastKind::t1, ContrastKind::weak_t1, ContrastKind::t2, ContrastKind::flair,
                          ContrastKind::proton_density}) {
    float before = -1;
    for (const float doubt : {0.f, 0.2f, 0.5f, 1.f, 2.f, 5.f, 20.f}) {
      const float stated = statedDoubt_mm(doubt, kind, use);
      EXPECT_GT(stated, before) << int(kind);
      EXPECT_LT(stated, use.doubt_most_mm);
      before = stated;
    }
  }
  PriorUse plain;
  plain.doubt_t2_scale_mm = 2, plain.doubt_t2_power = 2, plain.doubt_most_mm = 8;
  EXPECT_FLOAT_EQ(statedDoubt_mm(2, ContrastKind::t2, plain), 4);  // 8 / (1 + 8 / 8)
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
