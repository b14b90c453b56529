#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "dark_areas.h"

namespace facenav::coil_tracking {
namespace {

cv::Mat speckled(unsigned seed, double share) {
  cv::Mat noise(97, 131, CV_8U);
  cv::RNG(seed).fill(noise, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(noise, noise, {}, 1.2);
  cv::Mat dark(noise.rows + 2, noise.cols + 2, CV_8U, cv::Scalar(0));
  cv::Mat inside = dark(cv::Rect(1, 1, noise.cols, noise.rows));
  cv::Mat(noise < 128 + 40 * (share - 0.5)).copyTo(inside);
  return cv::min(dark, 1);
}

bool isBefore(const cv::Point& a, const cv::Point& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }

/// Compares outlines as sets of pixels: the first pixel of a border is arbitrary.
std::vector<Outline> sorted(std::vector<Outline> outlines) {
  for (Outline& outline : outlines) {
    std::sort(outline.begin(), outline.end(), isBefore);
    outline.erase(std::unique(outline.begin(), outline.end()), outline.end());
  }
  std::sort(outlines.begin(), outlines.end(), [](const Outline& a, const Outline& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), isBefore);
  });
  return outlines;
}

TEST(DarkAreas, OutlinesAreTheOuterBordersThatOpenCvFinds) {
  for (const unsigned seed : {1u, 2u, 3u, 4u})
    for (const double share : {0.3, 0.5, 0.7}) {
      const cv::Mat dark = speckled(seed, share);
      std::vector<Outline> all, expected;
      std::vector<cv::Vec4i> hierarchy;
      cv::findContours(dark.clone(), all, hierarchy, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE, {-1, -1});
      for (std::size_t i = 0; i < all.size(); ++i)
        if (hierarchy[i][3] < 0 && std::abs(cv::contourArea(all[i])) > 0) expected.push_back(all[i]);
      ASSERT_GT(expected.size(), 3u);
      EXPECT_EQ(sorted(outlinesOf(dark.clone(), 1).areas), sorted(expected)) << seed << ", " << share;
    }
}

TEST(DarkAreas, OutlinesRunClockwiseAndShortOnesAreLeftOut) {
  const auto outlines = outlinesOf(speckled(5, 0.5), 19).areas;
  ASSERT_GT(outlines.size(), 3u);
  for (const Outline& outline : outlines) {
    EXPECT_GE(outline.size(), 19u);
    EXPECT_GT(cv::contourArea(outline, true), 0.0);
  }
}

/// Computes the dark areas step by step with OpenCV's functions.
cv::Mat darkByOpenCv(const cv::Mat& grey, const Darkness& darkness) {
  cv::Mat low, high, tiles_low, tiles_high, dark(grey.size(), CV_8U);
  cv::erode(grey, low, cv::Mat::ones(2, 2, CV_8U), {0, 0});  // of a pixel and those right of and below it
  cv::dilate(grey, high, cv::Mat::ones(2, 2, CV_8U), {0, 0});
  cv::resize(low, tiles_low, {}, 0.5, 0.5, cv::INTER_NEAREST);
  cv::resize(high, tiles_high, {}, 0.5, 0.5, cv::INTER_NEAREST);
  cv::erode(tiles_low, tiles_low, cv::Mat());
  cv::dilate(tiles_high, tiles_high, cv::Mat());
  for (int y = 0; y < grey.rows; ++y)
    for (int x = 0; x < grey.cols; ++x) {
      const int least = tiles_low.at<uchar>(y / 2, x / 2), most = tiles_high.at<uchar>(y / 2, x / 2);
      const bool is_dark = most - least >= darkness.least_contrast_grey &&
                           grey.at<uchar>(y, x) < std::floor(least + darkness.share * (most - least) + 0.5);
      dark.at<uchar>(y, x) = is_dark;
    }
  return dark;
}

TEST(DarkAreas, ThresholdsLieBetweenTheDarkestAndTheBrightestNearby) {
  cv::Mat grey(64, 90, CV_8U);
  cv::RNG(3).fill(grey, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(grey, grey, {}, 1.5);
  for (const Darkness& darkness : {Darkness{}, Darkness{10, 0.25}}) {
    const cv::Mat areas = darkAreas(grey, darkness);
    EXPECT_EQ(cv::countNonZero(areas(cv::Rect(1, 1, 90, 64)) != darkByOpenCv(grey, darkness)), 0);
    EXPECT_EQ(cv::countNonZero(areas), cv::countNonZero(areas(cv::Rect(1, 1, 90, 64))));  // the rim is light
  }
}

}  // namespace
}  // namespace facenav::coil_tracking
