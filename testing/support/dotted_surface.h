#pragma once
// A rectified image pair of random dots on a smooth curved surface with exact disparities, for the tests and
// the benchmark of the dense matchers.

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "facenav/stereo/rectification.h"

namespace facenav::testing {

/// A rectified pair, disparities from 0 up; 8-bit images of one size.
struct RectifiedScene {
  stereo::Rectification rectification;
  stereo::RectifiedPair images;
  cv::Mat left8, right8;  // for matchers that need the same columns on both sides
};

inline RectifiedScene rectifiedScene(const cv::Mat& left, const cv::Mat& right, int disparities) {
  RectifiedScene scene;
  scene.left8 = left;
  scene.right8 = right;
  stereo::Rectification& r = scene.rectification;
  r.f_px = 800;
  r.baseline_mm = 120;
  r.disparities = disparities;
  r.left_mask = cv::Mat(left.size(), CV_8U, cv::Scalar(255));
  cv::copyMakeBorder(r.left_mask, r.right_mask, 0, 0, disparities, 0, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::Mat wide;
  cv::copyMakeBorder(right, wide, 0, 0, disparities, 0, cv::BORDER_REPLICATE);
  left.convertTo(scene.images.left, CV_32F);
  wide.convertTo(scene.images.right, CV_32F);
  return scene;
}

struct DottedSurface : RectifiedScene {
  cv::Mat truth_px;  // disparity of each left pixel
};

/// Makes a surface with dots about 5.6 px apart, 2 px wide, 130 grey levels bright; disparities from 5/32 to
/// 25/32 of `disparities`.
inline DottedSurface dottedSurface(int width, int height, int disparities, double noise_grey,
                                   std::uint64_t seed) {
  constexpr int kFine = 4;  // pattern pixels per image pixel
  cv::RNG random{seed};
  const int across = width + disparities + 32;
  cv::Mat pattern = cv::Mat::zeros(kFine * height, kFine * across, CV_32F);
  const int dots = int(across * height / 32.0);
  for (int i = 0; i < dots; ++i)
    cv::circle(pattern, {random.uniform(0, pattern.cols), random.uniform(0, pattern.rows)}, 4,
               cv::Scalar(130), -1);
  cv::GaussianBlur(pattern, pattern, {}, 0.8 * kFine);
  const double middle = 15.0 / 32 * disparities, bend_x = 7.5 / 32 * disparities,
               bend_y = 2.5 / 32 * disparities;
  const double period_x = 140.0, period_y = 90.0;
  const auto disparity = [&](double x, double y) {
    return middle + bend_x * std::sin(x / period_x) + bend_y * std::sin(y / period_y);
  };
  cv::Mat truth_px(height, width, CV_32F), left_map(height, width, CV_32FC2),
      right_map(height, width, CV_32FC2);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      truth_px.at<float>(y, x) = float(disparity(x, y));
      left_map.at<cv::Vec2f>(y, x) = {kFine * float(x), kFine * float(y)};
      double seen = x;  // left column of the point at this right pixel
      for (int i = 0; i < 40; ++i) seen = x + disparity(seen, y);
      right_map.at<cv::Vec2f>(y, x) = {kFine * float(seen), kFine * float(y)};
    }
  cv::Mat left, right, noise(height, width, CV_32F), left8, right8;
  cv::remap(pattern, left, left_map, cv::noArray(), cv::INTER_CUBIC);
  cv::remap(pattern, right, right_map, cv::noArray(), cv::INTER_CUBIC);
  random.fill(noise, cv::RNG::NORMAL, 50, noise_grey);
  cv::Mat(left + noise).convertTo(left8, CV_8U);
  random.fill(noise, cv::RNG::NORMAL, 50, noise_grey);
  cv::Mat(right + noise).convertTo(right8, CV_8U);
  DottedSurface surface;
  static_cast<RectifiedScene&>(surface) = rectifiedScene(left8, right8, disparities);
  surface.truth_px = truth_px;
  return surface;
}

}  // namespace facenav::testing
