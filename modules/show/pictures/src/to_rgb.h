#pragma once
// Converts an OpenCV picture to the RgbImage that this module returns.

#include <cstring>
#include <opencv2/core.hpp>

#include "facenav/core/rgb_image.h"

namespace facenav::pictures {

/// Converts `image`: 8-bit, 3 channels, R G B.
inline RgbImage toRgb(const cv::Mat& image) {
  RgbImage out(image.cols, image.rows);
  for (int v = 0; v < image.rows; ++v)
    std::memcpy(out.pixel(0, v), image.ptr(v), std::size_t(image.cols) * 3);
  return out;
}

}  // namespace facenav::pictures
