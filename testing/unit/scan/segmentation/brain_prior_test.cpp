#include "prior/brain_prior.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <thread>

#include "brain_start.h"
#include "contrast_seen.h"
#include "facenav/volume/regrid.h"
#include "head_phantom.h"
#include "prior/head_window.h"
#include "prior/leaks_and_gaps.h"
#include "prior/local_evidence.h"
#include "prior/scan_prior.h"

// The learned prior on the phantom, a head that training never showed, and the steps that refine it.

namespace facenav::segmentation {
namespace {

using testing::HeadPhantom;
using testing::makeHeadPhantom;
using volume::Mask;
using volume::Volume;

const HeadPhantom& phantom() {
  static const HeadPhantom head = makeHeadPhantom();
  return head;
}

BrainPrior priorOf(const Volume& scan) {
  const auto prior = findBrainPrior(*installedPrior().network, workingVolume(scan, 1.0));
  return prior ? *prior : BrainPrior();
}

double diceOf(const BrainPrior& prior) {
  if (prior.brain.voxels.empty()) return 0;
  return volume::overlap(volume::resample(prior.mask(), phantom().brain.grid), phantom().brain).dice;
}

/// Phantom in a scan with `more_mm` of air on one side of each axis.
Volume inMoreAir(const Eigen::Vector3d& more_mm) {
  volume::VoxelGrid grid = phantom().volume.grid;
  const Eigen::Vector3d h = grid.spacing_mm();
  for (int a = 0; a < 3; ++a) {
    const int more = int(std::abs(more_mm[a]) / h[a]);
    grid.size[a] += more;
    if (more_mm[a] < 0) grid.mri_from_voxel.translate(-more * Eigen::Vector3d::Unit(a));
  }
  return volume::resample(phantom().volume, grid);
}

TEST(BrainPrior, FindsThePhantomsBrain) {
  ASSERT_TRUE(installedPrior().network) << installedPrior().fault;
  EXPECT_GT(diceOf(priorOf(phantom().volume)), 0.85);
}

TEST(BrainPrior, FindsTheBrainWhereverItLiesInTheScan) {
  ASSERT_TRUE(installedPrior().network) << installedPrior().fault;
  EXPECT_GT(diceOf(priorOf(inMoreAir({120, -100, -150}))), 0.85);
}

TEST(ScanPrior, IsMadeOnceForAScanThatIsInUse) {
  const PriorNetwork& network = *installedPrior().network;
  const Volume scan = phantom().volume;
  std::shared_ptr<const ScanPrior> other_thread;
  std::thread asks([&] { other_thread = scanPrior(network, scan); });
  const auto first = scanPrior(network, scan);
  asks.join();
  EXPECT_EQ(first, other_thread);
  ASSERT_TRUE(first->prior);
  EXPECT_EQ(first->prior->brain.voxels, priorOf(scan).brain.voxels);
  Volume changed = scan;
  changed.voxels[changed.voxels.size() / 2] += 1;
  EXPECT_NE(scanPrior(network, changed), first);
  Volume moved = scan;
  moved.grid.mri_from_voxel.pretranslate(Eigen::Vector3d(0, 0, 1));
  EXPECT_NE(scanPrior(network, moved), first);
}

TEST(BrainPrior, FindsNoneInNoise) {
  Volume noise = phantom().volume;
  std::mt19937 random(2);
  for (float& v : noise.voxels) v = float(random() % 1000);
  EXPECT_TRUE(priorOf(noise).brain.voxels.empty());
}

TEST(HeadWindow, HoldsTheVoxelsAboutItsPlaceAndBlackBeyondTheScan) {
  Volume coarse;
  coarse.grid.size = {60, 60, 60};
  coarse.grid.mri_from_voxel.linear() *= 4;
  for (std::size_t v = 0; v < coarse.grid.count(); ++v) coarse.voxels.push_back(float(v % 60));
  const Volume window = headWindow(coarse, coarse.grid.toMri({10, 30, 30}));
  EXPECT_EQ(window.grid.size, kPriorSize);
  EXPECT_NEAR((window.grid.toMri({24, 28, 24}).mm - coarse.grid.toMri({10, 30, 30}).mm).norm(), 0, 1e-9);
  EXPECT_EQ(window.at(0, 28, 24), 0);  // 14 voxels left of the scan
  EXPECT_GT(window.at(40, 28, 24), window.at(30, 28, 24));
  EXPECT_NEAR(window.at(47, 28, 24), 1, 0.05);
}

TEST(LocalEvidence, FollowsTheContrastOfEachPlace) {
  // The inside is the brighter side on the left and the darker one on the right; shading is steeper than
  // both.
  Volume image;
  image.grid.size = {80, 40, 40};
  Mask inside{image.grid, std::vector<std::uint8_t>(image.grid.count())};
  std::size_t v = 0;
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 80; ++i, ++v) {
        inside.voxels[v] = k < 20;
        image.voxels.push_back(float(i < 40 ? (k < 20 ? 60 : 40) : (k < 20 ? 130 : 150)));
      }
  const Volume evidence = localEvidence(image, depthBelow(inside), PriorUse());
  EXPECT_GT(evidence.at(10, 20, 18), 1);
  EXPECT_LT(evidence.at(10, 20, 21), -1);
  EXPECT_GT(evidence.at(70, 20, 18), 1);
  EXPECT_LT(evidence.at(70, 20, 21), -1);
  EXPECT_EQ(evidence.at(10, 20, 0), 0);  // far from the outline
}

ContrastSeen contrastOf(const Volume& scan) {
  const Volume coarse = halved(workingVolume(scan, 1.0));
  Volume brain{phantom().brain.grid, {phantom().brain.voxels.begin(), phantom().brain.voxels.end()}, {}, {}};
  brain = volume::resample(brain, coarse.grid);
  const Volume none{coarse.grid, std::vector<float>(coarse.grid.count()), {}, {}};
  return contrastSeen(coarse, brain, none);
}

TEST(ContrastSeen, TellsAT1FromItsNegative) {
  EXPECT_TRUE(contrastOf(phantom().volume).isLikeT1());
  Volume negative = phantom().volume;
  for (float& v : negative.voxels) v = v < 10 ? v : 160 - v;
  EXPECT_FALSE(contrastOf(negative).isLikeT1());
}

TEST(ContrastSeen, HasAKindForEachContrast) {
  EXPECT_EQ((ContrastSeen{1.2, 0.5}).kind(), ContrastKind::t1);
  EXPECT_EQ((ContrastSeen{1.2, 0.85}).kind(), ContrastKind::weak_t1);
  EXPECT_TRUE((ContrastSeen{1.2, 0.85}).isLikeT1());
  EXPECT_EQ((ContrastSeen{0.6, 2}).kind(), ContrastKind::t2);
  EXPECT_EQ((ContrastSeen{0.9, 0.6}).kind(), ContrastKind::flair);
  EXPECT_EQ((ContrastSeen{1.1, 1}).kind(), ContrastKind::proton_density);
}

/// Box of `grid` from `low` to before `high`, without a slit of `slit` voxels in its middle.
Mask slitBox(const volume::VoxelGrid& grid, int low, int high, int slit) {
  Mask mask{grid, std::vector<std::uint8_t>(grid.count())};
  for (int k = low; k < high; ++k)
    for (int j = low; j < high; ++j)
      for (int i = low; i < high; ++i)
        mask.voxels[grid.index(i, j, k)] = i < 30 - slit / 2 || i >= 30 + (slit + 1) / 2 || k < 20;
  return mask;
}

TEST(LeaksAndGaps, AreNeitherAFissureNorAThinShell) {
  volume::VoxelGrid grid;
  grid.size = {60, 60, 60};
  const Mask prior = slitBox(grid, 15, 45, 4), closed = slitBox(grid, 13, 47, 0);
  EXPECT_LT(volume::overlap(prior, closed).dice, 0.85) << "a Dice would part them";
  EXPECT_EQ(leaksAndGaps(closed, prior, 4), 0);
  Mask leaking = closed, lacking = closed;
  for (int k = 20; k < 40; ++k)
    for (int j = 20; j < 40; ++j) {
      for (int i = 47; i < 57; ++i) leaking.voxels[grid.index(i, j, k)] = 1;
      for (int i = 13; i < 25; ++i) lacking.voxels[grid.index(i, j, k)] = 0;
    }
  EXPECT_GT(leaksAndGaps(leaking, prior, 4), 0.05);
  EXPECT_GT(leaksAndGaps(lacking, prior, 4), 0.01);
  EXPECT_EQ(leaksAndGaps(closed, Mask{grid, std::vector<std::uint8_t>(grid.count())}, 4), 1);
}

}  // namespace
}  // namespace facenav::segmentation
