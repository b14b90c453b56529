#include "facenav/stereo/dot_pattern.h"

#include <gtest/gtest.h>

using namespace facenav::stereo;

TEST(DotPattern, SparseHasOneDotOfTwoByTwoInEachBlock) {
  const cv::Mat pattern = makeDotPattern(DotPattern::sparse, 7);
  ASSERT_EQ(pattern.size(), cv::Size(1024, 768));
  ASSERT_EQ(pattern.type(), CV_8U);
  for (int y = 0; y < 768; y += 64)
    for (int x = 0; x < 1024; x += 64) EXPECT_EQ(cv::countNonZero(pattern(cv::Rect(x, y, 64, 64))), 4);
}

TEST(DotPattern, DenseCoversANinthOfTheImage) {
  const cv::Mat pattern = makeDotPattern(DotPattern::dense, 7, 1020, 768);
  EXPECT_EQ(cv::countNonZero(pattern), 170 * 128 * 4);
  EXPECT_EQ(cv::countNonZero(pattern), cv::countNonZero(pattern == 255));
}

TEST(DotPattern, IsTheSameForTheSameSeedAndAnotherForAnother) {
  for (DotPattern kind : {DotPattern::sparse, DotPattern::dense}) {
    EXPECT_EQ(cv::countNonZero(makeDotPattern(kind, 1) != makeDotPattern(kind, 1)), 0);
    EXPECT_GT(cv::countNonZero(makeDotPattern(kind, 1) != makeDotPattern(kind, 2)), 1000);
  }
}
