#include "matchers/block_search.h"

#include <gtest/gtest.h>

#include "analytic_scene.h"
#include "facenav/core/simd.h"

namespace facenav::stereo {
namespace {

using testing::analyticScene;
using testing::AnalyticScene;

/// Point in Camera of a rectified left pixel at that disparity; Camera and rectified frame are the same here.
Eigen::Vector3d pointAt(const Rectification& r, double x, double y, double disparity) {
  return r.point_mm(x, y, disparity);
}

TEST(BlockSearch, FindsASlantedPlaneToLessThanAPixel) {
  const AnalyticScene scene = analyticScene({14, 0.08, -0.05});
  const cv::Mat blocks = searchBlocks(scene.rectification, scene.images);
  ASSERT_EQ(blocks.size(), cv::Size(40, 30));
  int right = 0, all = 0;
  for (int y = 3; y < 27; ++y)
    for (int x = 3; x < 37; ++x, ++all)
      right += std::abs(blocks.at<float>(y, x) - scene.plane.at(4 * x + 1.5, 4 * y + 1.5)) < 0.75;
  EXPECT_GT(right, 0.97 * all);
  EXPECT_EQ(cv::countNonZero(blocks == blocks), int(blocks.total())) << "holes are filled";
}

TEST(BlockSearch, KernelsOfBothInstructionSetsFindTheSame) {
  if (instructionSet() != InstructionSet::avx2) GTEST_SKIP() << "this processor has no AVX2";
  const AnalyticScene scene = analyticScene({14, 0.08, -0.05});
  const cv::Mat fast = searchBlocks(scene.rectification, scene.images, block::avx2Kernel()),
                base = searchBlocks(scene.rectification, scene.images, block::baseKernel());
  EXPECT_LT(cv::norm(fast, base, cv::NORM_INF), 1e-3);
}

TEST(BlockSearch, MatchesNothingWhereThereIsNothingToMatch) {
  AnalyticScene scene = analyticScene({20});
  const int matched = matchedBlocks(scene.rectification, scene.images);
  EXPECT_GT(matched, 800) << "of 1200";
  AnalyticScene other = scene;
  other.images.right = analyticScene({20}, 160, 120, 48, 0, 99).images.right;  // another texture
  EXPECT_LT(matchedBlocks(other.rectification, other.images), matched / 4);
  scene.images.right = scene.images.right * 0 + 80;
  EXPECT_EQ(matchedBlocks(scene.rectification, scene.images), 0);
  const cv::Mat blocks = searchBlocks(scene.rectification, scene.images);
  EXPECT_EQ(cv::countNonZero(blocks == blocks), 0) << "all NaN";
}

TEST(BlockSearch, BlocksOutsideTheMaskAreNotMatched) {
  AnalyticScene scene = analyticScene({20});
  const int all = matchedBlocks(scene.rectification, scene.images);
  scene.rectification.left_mask(cv::Rect(0, 0, 80, 120)).setTo(0);
  const int half = matchedBlocks(scene.rectification, scene.images);
  EXPECT_LT(half, 0.55 * all);
  EXPECT_GT(half, 0.4 * all);
}

TEST(BlocksOf, PutsEachPointIntoItsBlockTheNearestFirst) {
  const Rectification r = analyticScene({20}).rectification;
  PointCloud<Camera> surface;
  surface.points_mm = {pointAt(r, 41.5, 22.5, 30), pointAt(r, 42.0, 21.0, 33), pointAt(r, 100.5, 80.5, 10)};
  surface.points_mm.emplace_back(0, 0, -500);            // behind the camera
  surface.points_mm.push_back(pointAt(r, -40, 20, 45));  // beside the image
  const cv::Mat blocks = blocksOf(r, {160, 120}, surface);
  EXPECT_NEAR(blocks.at<float>(5, 10), 33, 1e-3);
  EXPECT_NEAR(blocks.at<float>(20, 25), 10, 1e-3);
  double least = 0, most = 0;
  cv::minMaxLoc(blocks, &least, &most);
  EXPECT_GE(least, 10 - 1e-3) << "holes are filled with what is near, no wilder";
  EXPECT_LE(most, 33 + 1e-3);
}

TEST(BlocksOf, NoPointsAreNoSurface) {
  const Rectification r = analyticScene({20}).rectification;
  const cv::Mat blocks = blocksOf(r, {160, 120}, {});
  EXPECT_EQ(cv::countNonZero(blocks == blocks), 0);
}

}  // namespace
}  // namespace facenav::stereo
