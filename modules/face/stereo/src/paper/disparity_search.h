#pragma once
// Stage 1 of the "ssd" matcher (paper, section 7.1): whole-pixel disparities. Beyond the paper, the images
// are normalised locally and large differences are truncated.

#include <opencv2/core.hpp>

#include "facenav/stereo/rectification.h"

namespace facenav::stereo {

/// Finds for every pixel of the left image the place in the right one with the least sum of squared
/// differences (SSD) over a window (section 7.1; 11 x 11 px in the paper). 16-bit signed, size of the
/// rectified left image: the disparity, or -1 if unknown.
cv::Mat searchDisparities(const Rectification& rectification, const RectifiedPair& pair, int window_px);

}  // namespace facenav::stereo
