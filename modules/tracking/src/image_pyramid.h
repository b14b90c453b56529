#pragma once
// ImagePyramid: one image, slightly blurred (less noise, and bilinear sampling biased less), and its halves.
// Pixel x of level l lies at 2^l x of the image.

#include <array>
#include <opencv2/core.hpp>

namespace facenav::tracking {

constexpr int kLevels = 4;

struct ImagePyramid {
  std::array<cv::Mat1f, kLevels> level;

  ImagePyramid() = default;
  explicit ImagePyramid(const cv::Mat& grey);
};

/// Bilinear; the caller sees to it that x, y lie inside by one pixel.
inline float sampleAt(const cv::Mat1f& image, float x, float y) {
  const int ix = int(x), iy = int(y);
  const float fx = x - float(ix), fy = y - float(iy);
  const float *a = image.ptr<float>(iy) + ix, *b = image.ptr<float>(iy + 1) + ix;
  const float top = a[0] + fx * (a[1] - a[0]), bottom = b[0] + fx * (b[1] - b[0]);
  return top + fy * (bottom - top);
}

}  // namespace facenav::tracking
