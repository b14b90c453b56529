#pragma once
// Resamples an image at other places by quintic B-splines.

#include <opencv2/core.hpp>

namespace facenav::stereo {

/// `image`: 8-bit, 1 channel. `places`: 32-bit float, 2 channels, the pixel (x, y) of each output pixel.
/// Returns 32-bit float of the size of `places`; 0 more than a pixel outside the image.
cv::Mat resampled(const cv::Mat& image, const cv::Mat& places);

}  // namespace facenav::stereo
