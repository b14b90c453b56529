#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "facenav/peers/bet_segmenter.h"
#include "facenav/segmentation/segmenter.h"
#include "facenav/segmentation/tissue_share.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/regrid.h"
#include "head_phantom.h"

// The brain's mask against known answers: the phantom's ellipsoids. Real heads: brain_real_heads_test.cpp.

namespace facenav {
namespace {

using peers::makeBetSegmenter;
using segmentation::makeBrainSegmenter;
using testing::HeadPhantom;
using testing::makeHeadPhantom;
using testing::PhantomOptions;

volume::Mask brainOf(const volume::Volume& volume) {
  TaskMonitor monitor;
  return makeBrainSegmenter()->segment(volume, monitor).mask;
}

const HeadPhantom& plainHead() {
  static const HeadPhantom head = makeHeadPhantom();
  return head;
}

/// Result for the plain phantom, computed once for all tests.
const segmentation::SegmentationResult& plainBrain() {
  static const auto result = [] {
    TaskMonitor monitor;
    return makeBrainSegmenter()->segment(plainHead().volume, monitor);
  }();
  return result;
}

TEST(BrainSegmenter, FindsThePhantomsBrainAboveALongNeck) {
  const HeadPhantom& head = plainHead();
  const auto& brain = plainBrain().mask;
  ASSERT_TRUE(brain.grid.matches(head.volume.grid));
  const auto overlap = volume::overlap(brain, head.brain);
  EXPECT_GE(overlap.dice, 0.98);
  EXPECT_GE(overlap.inside, 0.98);
}

TEST(TissueShare, OpensTheSulciThatTheMaskCloses) {
  const HeadPhantom& head = plainHead();
  TaskMonitor monitor;
  const auto share = segmentation::tissueShare(head.volume, head.brain, 1.0, monitor);
  const Eigen::Vector3d low = share.grid.toMri({0, 0, 0}).mm;
  EXPECT_TRUE(share.grid.mri_from_voxel.linear().isApprox(Eigen::Matrix3d::Identity()));
  EXPECT_LT(low.x(), -66);
  EXPECT_GT(low.x(), -80);
  int inside = 0, open = 0, outside = 0;
  std::size_t at = 0;
  for (int k = 0; k < share.grid.size[2]; ++k)
    for (int j = 0; j < share.grid.size[1]; ++j)
      for (int i = 0; i < share.grid.size[0]; ++i, ++at) {
        const auto ijk = head.brain.grid.toVoxel(share.grid.toMri({double(i), double(j), double(k)}));
        const Eigen::Array3i n = ijk.array().round().cast<int>();
        const bool is_brain = head.brain.grid.contains(n[0], n[1], n[2]) && head.brain.at(n[0], n[1], n[2]);
        ASSERT_GE(share.voxels[at], 0);
        ASSERT_LE(share.voxels[at], 1);
        inside += is_brain;
        open += is_brain && share.voxels[at] < 0.5f;
        outside += !is_brain && share.voxels[at] > 0.75f;
      }
  EXPECT_GT(open, inside / 50);  // the phantom's sulci
  EXPECT_LT(open, inside / 5);
  EXPECT_LT(outside, inside / 200);
}

TEST(BrainSegmenter, StatesItsDoubtAllOverTheMasksSurface) {
  const auto& result = plainBrain();
  const auto to_surface_mm = volume::distanceTo(volume::surfaceVoxels(result.mask));
  std::array<int, 8> in_octant{};
  const Eigen::Vector3d centre = result.mask.grid.centre().mm;
  for (const auto& doubt : result.doubts) {
    const Eigen::Array3i at = result.mask.grid.toVoxel(doubt.place).array().round().cast<int>();
    ASSERT_TRUE(result.mask.grid.contains(at[0], at[1], at[2]));
    ASSERT_LE(to_surface_mm[result.mask.grid.index(at[0], at[1], at[2])], 2.5);  // a voxel of either grid
    ASSERT_GE(doubt.doubt_mm, 0);
    const auto side = (doubt.place.mm - centre).array() > 0;
    ++in_octant[side[0] + 2 * side[1] + 4 * side[2]];
  }
  for (int upper = 4; upper < 8; ++upper) EXPECT_GT(in_octant[upper], 500) << upper;
}

TEST(BrainSegmenter, FindsAChildsBrainInABiasField) {
  PhantomOptions child;
  child.size = 0.85, child.bias = 0.3, child.noise = 0.05;
  const HeadPhantom head = makeHeadPhantom(child);
  EXPECT_GE(volume::overlap(brainOf(head.volume), head.brain).dice, 0.95);
}

TEST(BrainSegmenter, GivesTheSameMaskForAnyAxisOrderGainAndOffset) {
  const HeadPhantom& head = plainHead();
  volume::Volume turned;
  turned.grid.size = {head.volume.grid.size[2], head.volume.grid.size[0], head.volume.grid.size[1]};
  Eigen::Matrix3d order;  // turned (a, b, c) = original (-b, c, -a), flipped where negative
  order << 0, -1, 0, 0, 0, 1, -1, 0, 0;
  const Eigen::Vector3d first(head.volume.grid.size[0] - 1, 0, head.volume.grid.size[2] - 1);
  turned.grid.mri_from_voxel =
      head.volume.grid.mri_from_voxel * (Eigen::Translation3d(first) * Eigen::Affine3d(order));
  for (int c = 0; c < turned.grid.size[2]; ++c)
    for (int b = 0; b < turned.grid.size[1]; ++b)
      for (int a = 0; a < turned.grid.size[0]; ++a)
        turned.voxels.push_back(head.volume.at(int(first.x()) - b, c, int(first.z()) - a));
  for (float& v : turned.voxels) v = 37 * v - 1500;
  const auto found = brainOf(turned);
  ASSERT_TRUE(found.grid.matches(turned.grid));
  EXPECT_GE(volume::overlap(volume::resample(found, head.volume.grid), plainBrain().mask).dice, 0.995);
}

TEST(BrainSegmenter, WarnsOfABrainCutByTheScansEdge) {
  const HeadPhantom& head = plainHead();
  volume::VoxelGrid lower = head.volume.grid;  // ends 35 mm below the brain's top
  lower.size[2] -= int((100 - 33) / head.volume.grid.spacing_mm().z());
  TaskMonitor monitor;
  const auto result = makeBrainSegmenter()->segment(volume::resample(head.volume, lower), monitor);
  std::string all;
  for (const auto& warning : result.warnings) all += warning + "; ";
  EXPECT_NE(all.find("cut by the scan's edge at the top"), std::string::npos) << all;
}

/// Share of the phantom's dura inside the mask.
double duraWithin(const volume::Mask& brain, const HeadPhantom& head) {
  return volume::overlap(head.dura, brain).inside;
}

TEST(BrainSegmenter, LeavesOutDuraBeyondAFilmOfFluid) {
  PhantomOptions options;
  options.has_dura = true;
  const HeadPhantom head = makeHeadPhantom(options);
  ASSERT_GT(head.dura.volume_ml(), 5);
  const auto found = brainOf(head.volume);
  EXPECT_LT(duraWithin(found, head), 0.1);
  EXPECT_GE(volume::overlap(found, head.brain).dice, 0.98);  // and the crown below it is kept
}

TEST(BetSegmenter, FindsThePhantomsBrainAboveALongNeck) {
  const HeadPhantom& head = plainHead();
  TaskMonitor monitor;
  EXPECT_GE(volume::overlap(makeBetSegmenter()->segment(head.volume, monitor).mask, head.brain).dice, 0.88);
}

}  // namespace
}  // namespace facenav
