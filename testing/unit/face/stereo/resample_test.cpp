#include "rectification/resample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "facenav/core/simd.h"
#include "kernels/resample_kernel.h"

namespace facenav::stereo {
namespace {

cv::Mat imageOf(int width, int height, const std::function<double(double, double)>& grey) {
  cv::Mat image(height, width, CV_8U);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.at<std::uint8_t>(y, x) = std::uint8_t(std::lround(grey(x, y)));
  return image;
}

/// Places over the image less `margin`, `off` from its pixels.
cv::Mat placesOf(const cv::Mat& image, int margin, double off_x, double off_y) {
  cv::Mat places(image.rows - 2 * margin, image.cols - 2 * margin, CV_32FC2);
  for (int y = 0; y < places.rows; ++y)
    for (int x = 0; x < places.cols; ++x)
      places.at<cv::Vec2f>(y, x) = {float(x + margin + off_x), float(y + margin + off_y)};
  return places;
}

TEST(Resampled, AtPixelsIsThePixel) {
  cv::RNG random{std::uint64_t(4)};
  cv::Mat image(37, 53, CV_8U), expected;
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  image.convertTo(expected, CV_32F);
  // A spline interpolates: it goes through all pixels, up to the image's edge.
  EXPECT_LT(cv::norm(resampled(image, placesOf(image, 0, 0, 0)), expected, cv::NORM_INF), 0.02);
}

TEST(Resampled, BetweenPixelsFollowsARamp) {
  const cv::Mat image = imageOf(60, 50, [](double x, double y) { return 20 + 2 * x + 2 * y; });
  for (const auto& [dx, dy] : {std::pair{0.5, 0.0}, {0.25, 0.75}, {0.013, 0.987}}) {
    const cv::Mat out = resampled(image, placesOf(image, 16, dx, dy));
    for (int y = 0; y < out.rows; ++y)
      for (int x = 0; x < out.cols; ++x)
        ASSERT_NEAR(out.at<float>(y, x), 20 + 2 * (x + 16 + dx) + 2 * (y + 16 + dy), 0.02);
  }
}

TEST(Resampled, AWaveOfSixPixelsLosesNoContrast) {
  const auto wave = [](double x, double y) {
    return 128 + 100 * std::sin(2 * M_PI * (0.8 * x + 0.6 * y) / 6);
  };
  const cv::Mat image = imageOf(80, 60, wave);
  double squares = 0;
  const cv::Mat out = resampled(image, placesOf(image, 14, 0.5, 0.5));
  for (int y = 0; y < out.rows; ++y)
    for (int x = 0; x < out.cols; ++x) squares += std::pow(out.at<float>(y, x) - wave(x + 14.5, y + 14.5), 2);
  // Rounding to 8 bits alone is 0.29 grey levels; linear interpolation would be off by 13.
  EXPECT_LT(std::sqrt(squares / double(out.total())), 1.0);
}

TEST(Resampled, OutsideTheImageIsBlack) {
  const cv::Mat image(20, 30, CV_8U, cv::Scalar(200));
  cv::Mat places(1, 6, CV_32FC2);
  places.at<cv::Vec2f>(0, 0) = {-1.1f, 10};
  places.at<cv::Vec2f>(0, 1) = {10, -1.1f};
  places.at<cv::Vec2f>(0, 2) = {30.1f, 10};
  places.at<cv::Vec2f>(0, 3) = {10, 20.1f};
  places.at<cv::Vec2f>(0, 4) = {-5000, 1e6f};
  places.at<cv::Vec2f>(0, 5) = {29, 19};  // the last pixel
  const cv::Mat out = resampled(image, places);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(out.at<float>(0, i), 0.0f) << i;
  EXPECT_NEAR(out.at<float>(0, 5), 200, 0.05);
}

TEST(Resampled, KernelsOfBothInstructionSetsAgree) {
  if (instructionSet() != InstructionSet::avx2) GTEST_SKIP() << "this processor has no AVX2";
  cv::RNG random{std::uint64_t(9)};
  cv::Mat fast(33, 41, CV_32F);
  random.fill(fast, cv::RNG::UNIFORM, 0, 255);
  cv::Mat base = fast.clone();
  resample::avx2Kernel().filter_columns(fast.ptr<float>(), int(fast.step1()), fast.cols, fast.rows, -0.43f);
  resample::baseKernel().filter_columns(base.ptr<float>(), int(base.step1()), base.cols, base.rows, -0.43f);
  EXPECT_LT(cv::norm(fast, base, cv::NORM_INF), 1e-3 * cv::norm(base, cv::NORM_INF));
}

}  // namespace
}  // namespace facenav::stereo
