#include "facenav/prepare/brain_confidence.h"

#include <gtest/gtest.h>

#include "support/test_data.h"

namespace facenav::steps {
namespace {

using segmentation::BoundaryDoubt;

atlas::AtlasMap sameSpace() {
  volume::VoxelGrid grid;
  grid.size = {2, 2, 2};
  return {Eigen::Affine3d::Identity(), grid, std::vector<Eigen::Vector3f>(8, Eigen::Vector3f::Zero())};
}

/// 40 places around each of two known points in MNI space; those of the left temporal pole are uncertain.
std::vector<BoundaryDoubt> doubts() {
  std::vector<BoundaryDoubt> all;
  for (int n = 0; n < 40; ++n) {
    const double off = 0.1 * n - 2;
    all.push_back({Point<Mri>(-40 + off, 16, -32), n < 30 ? 6.f : 1.f});
    all.push_back({Point<Mri>(20 + off, -98, 5), n < 2 ? 3.f : 1.f});
  }
  all.push_back({Point<Mri>(37, -21, 62), 20.f});  // a region with one place is left out
  return all;
}

TEST(BrainConfidence, NamesTheRegionWhoseEdgeIsUncertain) {
  FACENAV_NEEDS(testing::colin27());
  const auto colin = atlas::readColin27();
  const auto map = sameSpace();
  const auto regions = regionConfidence(doubts(), &map, &colin);
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[0].region, "left temporal pole");
  EXPECT_DOUBLE_EQ(regions[0].confidence, 0.25);
  EXPECT_DOUBLE_EQ(regions[0].doubt_mm, 6);
  EXPECT_EQ(regions[1].region, "right occipital lobe");
  EXPECT_DOUBLE_EQ(regions[1].confidence, 0.95);
  const auto words = whereToLook(regions);
  ASSERT_EQ(words.size(), 1u);
  EXPECT_EQ(words[0],
            "look at the left temporal pole: the mask's edge is uncertain by 6 mm there (confidence 0.25)");
}

TEST(BrainConfidence, WithoutAnAtlasSpeaksOfTheWholeBrain) {
  const auto regions = regionConfidence(doubts(), nullptr, nullptr);
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_EQ(regions[0].region, "whole brain");
  EXPECT_NEAR(regions[0].confidence, 48.0 / 81, 1e-12);
}

TEST(BrainConfidence, SaysNothingWhereTheMethodStatesNoDoubt) {
  EXPECT_TRUE(regionConfidence({}, nullptr, nullptr).empty());
  EXPECT_TRUE(whereToLook({}).empty());
}

}  // namespace
}  // namespace facenav::steps
