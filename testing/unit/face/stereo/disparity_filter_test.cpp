#include "matchers/disparity_filter.h"

#include <gtest/gtest.h>

#include <limits>

namespace facenav::stereo {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

cv::Mat empty(int rows, int columns) { return cv::Mat(rows, columns, CV_32F, cv::Scalar(kNone)); }
int countOf(const cv::Mat& map) { return cv::countNonZero(map == map); }

TEST(RemoveSpeckles, DropsAPatchOfOneTooFewAndKeepsTheNext) {
  for (const int size : {7, 8}) {
    cv::Mat map = empty(20, 30);
    map(cv::Rect(3, 4, size, 1)).setTo(12);
    removeSpeckles(map, 8, 1.0f);
    EXPECT_EQ(countOf(map), size < 8 ? 0 : 8);
  }
}

TEST(RemoveSpeckles, CornersDoNotConnect) {
  cv::Mat map = empty(10, 10);
  map(cv::Rect(0, 0, 3, 3)).setTo(5);
  map(cv::Rect(3, 3, 3, 3)).setTo(5);  // touches the first at a corner
  removeSpeckles(map, 10, 1.0f);
  EXPECT_EQ(countOf(map), 0);
}

TEST(RemoveSpeckles, RowsDoNotConnectOverTheImagesEdge) {
  cv::Mat map = empty(4, 6);
  map(cv::Rect(4, 1, 2, 1)).setTo(5);  // end of one row
  map(cv::Rect(0, 2, 2, 1)).setTo(5);  // begin of the next
  removeSpeckles(map, 4, 1.0f);
  EXPECT_EQ(countOf(map), 0);
}

TEST(RemoveSpeckles, ASlopeIsOnePatchAndAStepTwo) {
  cv::Mat slope = empty(3, 40), step = empty(3, 40);
  for (int x = 0; x < 40; ++x) {
    slope.col(x).setTo(0.9f * float(x));
    step.col(x).setTo(x < 30 ? 5.0f : 7.0f);
  }
  removeSpeckles(slope, 100, 1.0f);
  EXPECT_EQ(countOf(slope), 120);
  removeSpeckles(step, 50, 1.0f);
  EXPECT_EQ(countOf(step), 90) << "30 of 120 belong to another surface";
  EXPECT_EQ(step.at<float>(1, 29), 5.0f);
}

TEST(RemoveSpeckles, OfNothingAndOfSizeZeroLeaveAllAsItIs) {
  cv::Mat none = empty(5, 5);
  removeSpeckles(none, 3, 1.0f);
  EXPECT_EQ(countOf(none), 0);
  cv::Mat one = empty(5, 5);
  one.at<float>(2, 2) = 1;
  removeSpeckles(one, 0, 1.0f);
  EXPECT_EQ(countOf(one), 1);
}

TEST(WithoutSpeckles, LeavesSlopesAndDeviationsAlone) {
  DisparityMap map;
  map.disparity_px = empty(10, 10);
  map.disparity_px.at<float>(5, 5) = 3;
  map.disparity_px(cv::Rect(0, 0, 4, 4)).setTo(9);
  map.sigma_px = cv::Mat(10, 10, CV_32F, cv::Scalar(0.1));
  map.slope_x = cv::Mat(10, 10, CV_32F, cv::Scalar(0.2));
  const DisparityMap clean = withoutSpeckles(map, 16);
  EXPECT_EQ(countOf(clean.disparity_px), 16);
  EXPECT_EQ(cv::countNonZero(clean.sigma_px == 0.1f), 100);
  EXPECT_EQ(cv::countNonZero(clean.slope_x == 0.2f), 100);
}

}  // namespace
}  // namespace facenav::stereo
