// The matchers' inner stages on planes of known disparity and slope.

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "analytic_scene.h"
#include "facenav/stereo/dense_matcher.h"
#include "matchers/disparity_field.h"
#include "matchers/plane_field.h"
#include "paper/disparity_search.h"

namespace facenav::stereo {
namespace {

using testing::Accuracy;
using testing::accuracyOf;
using testing::analyticScene;
using testing::AnalyticScene;
using testing::truthOf;

/// True disparity of each 4 x 4 pixels, changed by half a pixel up and down.
cv::Mat startOf(const AnalyticScene& scene) {
  cv::Mat blocks((scene.images.left.rows + 3) / 4, (scene.images.left.cols + 3) / 4, CV_32F);
  for (int y = 0; y < blocks.rows; ++y)
    for (int x = 0; x < blocks.cols; ++x)
      blocks.at<float>(y, x) =
          float(scene.plane.at(4 * x + 1.5, 4 * y + 1.5) + 0.4 * std::sin(0.3 * x) * std::cos(0.4 * y));
  return blocks;
}

class SlantedPlanes : public ::testing::TestWithParam<testing::DisparityPlane> {};

TEST_P(SlantedPlanes, ThePlaneFieldFindsDisparityAndSlopes) {
  const AnalyticScene scene = analyticScene(GetParam());
  const MatchImages images(scene.rectification, scene.images);
  PlaneField field(images);
  field.start(startOf(scene));
  for (int step = 0; step < 5; ++step) field.step(3.0);
  const DisparityMap map = field.map({});
  const Accuracy a = accuracyOf(map.disparity_px, truthOf(scene));
  EXPECT_GT(a.found, 0.97);
  EXPECT_LT(a.rms_px, 0.02);
  EXPECT_LT(std::abs(a.mean_px), 0.005);
  const cv::Mat slope_x(map.slope_x.size(), CV_32F, cv::Scalar(scene.plane.a)),
      slope_y(map.slope_y.size(), CV_32F, cv::Scalar(scene.plane.b));
  EXPECT_LT(accuracyOf(map.slope_x, slope_x).rms_px, 0.01);
  EXPECT_LT(accuracyOf(map.slope_y, slope_y).rms_px, 0.01);
}

TEST_P(SlantedPlanes, TheDisparityFieldKeepsIt) {
  const AnalyticScene scene = analyticScene(GetParam());
  const MatchImages images(scene.rectification, scene.images);
  PlaneField planes(images);
  planes.start(startOf(scene));
  for (int step = 0; step < 3; ++step) planes.step(3.0);
  DisparityField field(images);
  field.start(planes.nodes());
  field.step(2.5);
  const double rms_px = accuracyOf(field.map({}).disparity_px, truthOf(scene)).rms_px;
  EXPECT_LT(rms_px, 0.03);
  field.addDetail(1.9);
  EXPECT_LT(accuracyOf(field.map({}).disparity_px, truthOf(scene)).rms_px, rms_px + 0.01)
      << "there is no detail to add";
}

TEST_P(SlantedPlanes, SsdIsSubPixel) {
  const AnalyticScene scene = analyticScene(GetParam());
  MatchOptions options;
  options.refinements = 0;
  const DisparityMap map = makeDenseMatcher("ssd")->match(scene.rectification, scene.images, options);
  const Accuracy a = accuracyOf(map.disparity_px, truthOf(scene));
  EXPECT_GT(a.found, 0.9);
  EXPECT_LT(a.rms_px, 0.03);
}

TEST_P(SlantedPlanes, SgmIsSubPixelToAQuarter) {
  const AnalyticScene scene = analyticScene(GetParam());
  const DisparityMap map = makeDenseMatcher("sgm")->match(scene.rectification, scene.images, {});
  const Accuracy a = accuracyOf(map.disparity_px, truthOf(scene));
  EXPECT_GT(a.found, 0.9);
  EXPECT_LT(a.rms_px, 0.25);
}

INSTANTIATE_TEST_SUITE_P(Each, SlantedPlanes,
                         ::testing::Values(testing::DisparityPlane{20.37}, testing::DisparityPlane{16, 0.1},
                                           testing::DisparityPlane{25.5, -0.08, 0.06}));

TEST(SsdSearch, WholePixelsAreTheNearestOnes) {
  const AnalyticScene scene = analyticScene({20.3});
  const cv::Mat found = searchDisparities(scene.rectification, scene.images, 11);
  ASSERT_EQ(found.type(), CV_16S);
  int right = 0, all = 0;
  for (int y = 8; y < found.rows - 8; ++y)
    for (int x = 8; x < found.cols - 8; ++x, ++all) right += found.at<std::int16_t>(y, x) == 20;
  EXPECT_GT(right, 0.95 * all);
}

TEST(SsdSearch, RefusesWindowsThatAreEvenOrOutOfRange) {
  const AnalyticScene scene = analyticScene({20.3});
  for (const int window_px : {3, 6, 13, 0, -5})
    EXPECT_THROW(searchDisparities(scene.rectification, scene.images, window_px), std::logic_error)
        << window_px;
}

TEST(SsdSearch, PixelsOutsideTheMaskHaveNone) {
  AnalyticScene scene = analyticScene({20});
  scene.rectification.left_mask(cv::Rect(0, 0, 70, 120)).setTo(0);
  const cv::Mat found = searchDisparities(scene.rectification, scene.images, 9);
  EXPECT_EQ(cv::countNonZero(found(cv::Rect(0, 0, 70, 120)) >= 0), 0);
  EXPECT_GT(cv::countNonZero(found(cv::Rect(80, 10, 70, 100)) >= 0), 6000);
}

TEST(PlaneField, RefusesAStartOfAnotherSize) {
  const AnalyticScene scene = analyticScene({20});
  const MatchImages images(scene.rectification, scene.images);
  PlaneField field(images);
  EXPECT_THROW(field.start(cv::Mat(30, 39, CV_32F, cv::Scalar(20))), std::logic_error);
}

/// Share of the field's pixels that are accepted with these options.
double acceptedWith(const MatchOptions& options, const AnalyticScene& scene) {
  const DisparityMap map = makeDenseMatcher("field")->match(scene.rectification, scene.images, options);
  return accuracyOf(map.disparity_px, truthOf(scene)).found;
}

TEST(MatchOptions, EachLimitDropsWhatExceedsIt) {
  const AnalyticScene scene = analyticScene({4, 0.25});
  EXPECT_GT(acceptedWith({}, scene), 0.7);
  MatchOptions slope, sigma, patch;
  slope.largest_slope = 0.2;
  sigma.largest_sigma_px = 1e-6;
  patch.smallest_patch_px = 100000;
  EXPECT_LT(acceptedWith(slope, scene), 0.05);
  EXPECT_EQ(acceptedWith(sigma, scene), 0.0);
  EXPECT_EQ(acceptedWith(patch, scene), 0.0);
}

TEST(MatchOptions, LeastCorrelationDropsAnotherTexture) {
  AnalyticScene scene = analyticScene({20});
  scene.images.right = analyticScene({20}, 160, 120, 48, 0, 77).images.right;
  MatchOptions options;
  options.least_correlation = 0.9;
  EXPECT_LT(acceptedWith(options, scene), 0.02);
}

TEST(MatchOptions, RangesHoldTheDefaultsAndNameEachOnce) {
  std::vector<std::string> names;
  const MatchOptions defaults;
  MatchOptions::visit(defaults, [&](const Field& field, const auto& value) {
    names.push_back(field.name);
    EXPECT_LE(field.minimum, double(value)) << field.name;
    EXPECT_GE(field.maximum, double(value)) << field.name;
    EXPECT_FALSE(std::string(field.help).empty()) << field.name;
  });
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  EXPECT_EQ(names.size(), 13u);
}

}  // namespace
}  // namespace facenav::stereo
