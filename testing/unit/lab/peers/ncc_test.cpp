#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "ncc.h"
#include "support/matchers.h"

namespace facenav::peers {
namespace {

using facenav::testing::EigenNear;

cv::Mat smoothTexture(int seed) {
  cv::Mat1f field(120, 160);
  cv::RNG random(static_cast<std::uint64_t>(seed));
  random.fill(field, cv::RNG::UNIFORM, 0, 255);
  cv::GaussianBlur(field, field, {0, 0}, 3.0);
  cv::normalize(field, field, 20, 235, cv::NORM_MINMAX);
  cv::Mat image;
  field.convertTo(image, CV_8U);
  return image;
}

TEST(Ncc, KnownAnswerByHand) {
  // Means 2.5 and 5: products of deviations sum to 10, squares to 5 and 20: 10 / sqrt(100) = 1.
  const cv::Mat a = (cv::Mat_<uchar>(2, 2) << 1, 2, 3, 4), b = (cv::Mat_<uchar>(2, 2) << 2, 4, 6, 8);
  EXPECT_NEAR(ncc(a, b), 1.0, 1e-6);
  // Deviations (-1.5 -.5 .5 1.5) and (.5 -1.5 1.5 -.5): sum -.75 + .75 + .75 - .75 = 0.
  const cv::Mat c = (cv::Mat_<uchar>(2, 2) << 3, 1, 4, 2);
  EXPECT_NEAR(ncc(a, c), 0.0, 1e-6);
  const cv::Mat reversed = (cv::Mat_<uchar>(2, 2) << 4, 3, 2, 1);
  EXPECT_NEAR(ncc(a, reversed), -1.0, 1e-6);
}

TEST(Ncc, GainAndOffsetDoNotMatterButAFlatPatchScoresNothing) {
  const cv::Mat patch = smoothTexture(1)({40, 40, 21, 21});
  cv::Mat darker;
  patch.convertTo(darker, CV_8U, 0.5, 40);
  EXPECT_GT(ncc(darker, patch), 0.995);
  EXPECT_EQ(ncc(cv::Mat(21, 21, CV_8U, cv::Scalar(7)), patch), 0.0);
}

TEST(NccPeak, FindsASubpixelShiftToATwentiethOfAPixel) {
  const cv::Mat image = smoothTexture(2);
  const Eigen::Vector2d shift(3.3, -2.6);
  cv::Mat moved;
  cv::warpAffine(image, moved, cv::Matx23d(1, 0, shift.x(), 0, 1, shift.y()), image.size(), cv::INTER_CUBIC);
  const auto peak = findPeak(moved, image({60, 40, 21, 21}), {70, 50}, 8);
  ASSERT_TRUE(peak);
  EXPECT_THAT(peak->px, EigenNear(Eigen::Vector2d(70, 50) + shift, 0.05));
  EXPECT_GT(peak->ncc, 0.99);
}

TEST(NccPeak, APeakOnTheBorderOfTheSearchIsNone) {
  const cv::Mat image = smoothTexture(3);
  const cv::Mat patch = image({60, 40, 21, 21});
  EXPECT_FALSE(findPeak(image, patch, {66, 50}, 4));  // the true place lies at the border
  EXPECT_TRUE(findPeak(image, patch, {67, 50}, 4));
}

TEST(NccPeak, OutsideTheImageIsNone) {
  const cv::Mat image = smoothTexture(4);
  EXPECT_FALSE(findPeak(image, image({60, 40, 21, 21}), {-30, 50}, 5));
  EXPECT_FALSE(findPeak(image, image({60, 40, 21, 21}), {1e300, NAN}, 5));
}

}  // namespace
}  // namespace facenav::peers
