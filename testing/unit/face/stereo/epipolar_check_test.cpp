#include "cloud/epipolar_check.h"

#include <gtest/gtest.h>

#include <limits>

#include "analytic_scene.h"

namespace facenav::stereo {
namespace {

using testing::analyticScene;
using testing::AnalyticScene;
using testing::truthOf;

std::optional<double> medianOf(const AnalyticScene& scene) {
  DisparityMap map;
  map.disparity_px = truthOf(scene);
  map.slope_x = cv::Mat(map.disparity_px.size(), CV_32F, cv::Scalar(scene.plane.a));
  map.slope_y = cv::Mat(map.disparity_px.size(), CV_32F, cv::Scalar(scene.plane.b));
  return epipolarMedian(scene.rectification, scene.images, map);
}

TEST(EpipolarCheck, MeasuresByHowMuchRowsAreOff) {
  for (const double rows_px : {0.0, 0.3, -0.7, 0.9}) {
    const auto median_px = medianOf(analyticScene({20, 0.06, -0.04}, 160, 120, 48, rows_px));
    ASSERT_TRUE(median_px);
    EXPECT_NEAR(*median_px, std::abs(rows_px), 0.08) << rows_px;
  }
}

TEST(EpipolarCheck, IsBlindToGainAndOffset) {
  AnalyticScene scene = analyticScene({20}, 160, 120, 48, 0.5);
  const double before_px = *medianOf(scene);
  scene.images.right = scene.images.right * 0.6 + 30;
  ASSERT_TRUE(medianOf(scene));
  EXPECT_NEAR(*medianOf(scene), before_px, 1e-3);
}

TEST(EpipolarCheck, ADisparityThatIsSlightlyOffIsNoRowError) {
  AnalyticScene scene = analyticScene({20.0});
  scene.plane.d = 20.2;  // what the map contains
  EXPECT_LT(*medianOf(scene), 0.05);
}

TEST(EpipolarCheck, SaysNothingWithoutEnoughMatches) {
  const AnalyticScene scene = analyticScene({20});
  DisparityMap none;
  none.disparity_px =
      cv::Mat(scene.images.left.size(), CV_32F, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_FALSE(epipolarMedian(scene.rectification, scene.images, none));
  none.disparity_px(cv::Rect(40, 40, 20, 20)).setTo(20);  // too few windows
  EXPECT_FALSE(epipolarMedian(scene.rectification, scene.images, none));
}

TEST(EpipolarCheck, SaysNothingOfAPictureWithoutTexture) {
  AnalyticScene scene = analyticScene({20}, 160, 120, 48, 0.7);
  scene.images.left.setTo(120), scene.images.right.setTo(118);
  EXPECT_FALSE(medianOf(scene)) << "one grey value";
  cv::RNG random{7};
  for (cv::Mat* image : {&scene.images.left, &scene.images.right}) {
    cv::Mat noise(image->size(), CV_32F);
    random.fill(noise, cv::RNG::NORMAL, 0, 2);
    *image += noise;
  }
  EXPECT_FALSE(medianOf(scene)) << "noise alone";
}

/// Vertical stripes match at one disparity but look the same in every row.
TEST(EpipolarCheck, SaysNothingOfAPictureThatIsTheSameInEveryRow) {
  AnalyticScene scene = analyticScene({20}, 160, 120, 48, 0.7);
  for (cv::Mat* image : {&scene.images.left, &scene.images.right})
    for (int row = 1; row < image->rows; ++row) image->row(0).copyTo(image->row(row));
  scene.images.left = scene.images.right.colRange(28, 28 + 160).clone();  // at the plane's disparity
  EXPECT_FALSE(medianOf(scene));
}

TEST(EpipolarCheck, MeasuresFaintTextureUnderNoise) {
  AnalyticScene scene = analyticScene({20, 0.06, -0.04}, 160, 120, 48, 0.7);
  cv::RNG random{7};
  for (cv::Mat* image : {&scene.images.left, &scene.images.right}) {
    cv::Mat noise(image->size(), CV_32F);
    random.fill(noise, cv::RNG::NORMAL, 0, 1.5);
    *image = 0.2 * *image + 96 + noise;  // 8 grey levels of texture
  }
  ASSERT_TRUE(medianOf(scene));
  EXPECT_NEAR(*medianOf(scene), 0.7, 0.12);
}

}  // namespace
}  // namespace facenav::stereo
