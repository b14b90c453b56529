#include "facenav/evaluation/synthetic_head.h"

#include <gtest/gtest.h>

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/evaluation/mask_agreement.h"
#include "support/test_data.h"

namespace facenav::evaluation {
namespace {

constexpr int kSide = 64;
constexpr double kBrain_mm = 18, kSkull_mm = 22, kSkin_mm = 26;

/// Balls about the middle: white matter, fluid, bone by label; 1 mm.
LabelledHead ballHead() {
  LabelledHead head;
  head.name = "ball", head.grid.size = {kSide, kSide, kSide};
  for (int k = 0; k < kSide; ++k)
    for (int j = 0; j < kSide; ++j)
      for (int i = 0; i < kSide; ++i) {
        const double r = (Eigen::Vector3d(i, j, k).array() - 0.5 * (kSide - 1)).matrix().norm();
        head.labels.push_back(r < kBrain_mm ? 2 : r < kSkull_mm ? 24 : r < kSkin_mm ? 514 : 0);
      }
  return head;
}

std::map<int, LabelStatistics> statistics() {
  return {{0, {0, 0, 0, 0, 0}}, {2, {1, 160, 5, 0, 0}}, {24, {2, 40, 5, 0, 0}}, {514, {3, 90, 5, 0, 0}}};
}

/// Ranges in which only the means are drawn.
SyntheticRanges plain() {
  SyntheticRanges ranges;
  ranges.turn_deg = ranges.bend_mm = 0, ranges.least_size = ranges.most_size = 1;
  ranges.least_bias = ranges.most_bias = ranges.least_noise = ranges.most_noise = 0;
  ranges.least_blur_mm2 = ranges.most_blur_mm2 = 0;
  return ranges;
}

double ballVolume_ml(double radius_mm) { return 4.0 / 3 * M_PI * std::pow(radius_mm, 3) * 1e-3; }

TEST(SyntheticHead, UnmovedTissueIsTheLabelsOwn) {
  const auto made = makeSyntheticHead(ballHead(), statistics(), SyntheticContrast::t1, 1, plain());
  EXPECT_NEAR(made.tissue.volume_ml(), ballVolume_ml(kBrain_mm), 0.01 * ballVolume_ml(kBrain_mm));
  EXPECT_TRUE(made.tissue.at(kSide / 2, kSide / 2, kSide / 2));
  EXPECT_FALSE(made.tissue.at(kSide / 2 + 20, kSide / 2, kSide / 2));  // fluid
}

TEST(SyntheticHead, T1ValuesFollowTheStatistics) {
  const auto made = makeSyntheticHead(ballHead(), statistics(), SyntheticContrast::t1, 1, plain());
  const int middle = kSide / 2;
  EXPECT_NEAR(made.scan.at(middle, middle, middle), 160, 25);  // five deviations between scans
  EXPECT_NEAR(made.scan.at(middle + 20, middle, middle), 40, 25);
  EXPECT_NEAR(made.scan.at(middle + 24, middle, middle), 90, 25);
  EXPECT_LT(made.scan.at(0, 0, 0), 6);
}

TEST(SyntheticHead, AnyContrastChangesTheOrderOfTissues) {
  int brighter_fluid = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const auto made = makeSyntheticHead(ballHead(), statistics(), SyntheticContrast::any, seed, plain());
    brighter_fluid += made.scan.at(kSide / 2 + 20, kSide / 2, kSide / 2) > made.scan.at(32, 32, 32);
  }
  EXPECT_GT(brighter_fluid, 0);
  EXPECT_LT(brighter_fluid, 8);
}

TEST(SyntheticHead, SizeIsWithinItsRangeAndSeedDecides) {
  const auto one = makeSyntheticHead(ballHead(), statistics(), SyntheticContrast::t1, 7);
  const auto same = makeSyntheticHead(ballHead(), statistics(), SyntheticContrast::t1, 7);
  const auto other = makeSyntheticHead(ballHead(), statistics(), SyntheticContrast::t1, 8);
  EXPECT_EQ(one.scan.voxels, same.scan.voxels);
  EXPECT_NE(one.tissue.voxels, other.tissue.voxels);
  const SyntheticRanges ranges;
  EXPECT_GT(one.tissue.volume_ml(), 0.85 * ballVolume_ml(kBrain_mm * ranges.least_size));
  EXPECT_LT(one.tissue.volume_ml(), 1.15 * ballVolume_ml(kBrain_mm * ranges.most_size));
}

TEST(HeadLabels, NamesMayHoldCommas) {
  const facenav::testing::TemporaryFolder folder;
  const auto file = folder.path() / "statistics.csv";
  writeWholeFile(file,
                 "label,name,class,a,b,c,d\n0,background,0,7,1.75,5,2.5\n506,cavity, air,15,18,3,13,7\n");
  const auto rows = readLabelStatistics(file);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows.at(506).tissue_class, 15);
  EXPECT_EQ(rows.at(506).mean_of_means, 18);
  EXPECT_EQ(rows.at(506).deviation_of_deviations, 7);
  writeWholeFile(file, "label,name,class,a,b,c,d\n0,background,zero,7,1,5,2\n");
  EXPECT_THROW(readLabelStatistics(file), Error);
}

TEST(HeadLabels, OfSharedHeadsHaveABrainOfAdultSize) {
  const auto folder = facenav::testing::sharedData() / "head_labels";
  FACENAV_NEEDS(folder);
  const auto paths = labelledHeads(folder);
  ASSERT_EQ(paths.size(), 16u);
  const LabelledHead head = readLabelledHead(paths.front());
  volume::Mask tissue{head.grid, {}};
  for (const auto label : head.labels) tissue.voxels.push_back(isBrainTissue(label));
  EXPECT_GT(closedAndFilled(tissue).volume_ml(), 1000);
  EXPECT_LT(closedAndFilled(tissue).volume_ml(), 1700);
}

}  // namespace
}  // namespace facenav::evaluation
