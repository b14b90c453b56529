#pragma once
// Stage 1 of the "ssd" matcher: whole-pixel disparities by truncated SSD of locally normalised images.

#include <opencv2/core.hpp>

#include "facenav/stereo/rectification.h"

namespace facenav::stereo {

/// 16-bit signed, size of the rectified left image: the disparity, or -1 if unknown.
cv::Mat searchDisparities(const Rectification& rectification, const RectifiedPair& pair, int window_px);

}  // namespace facenav::stereo
