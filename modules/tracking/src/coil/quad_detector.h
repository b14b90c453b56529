#pragma once
// Dark quadrangles on light ground (paper, section 5, steps 1 to 3): binarise, label the dark areas, pick
// those with four corners. The threshold is the middle between the darkest and brightest grey nearby, so that
// lamps and shadows do not matter; flat areas, where there is nothing to threshold, count as light.

#include <opencv2/core.hpp>
#include <vector>

#include "marker_pattern.h"

namespace facenav::tracking {

struct QuadOptions {
  double least_side_px = 6.0;
  int least_contrast_grey = 24;  // between darkest and brightest nearby
  double dark_share = 0.5;       // of the range between darkest and brightest that counts as dark
};

/// 255 where dark. 8-bit, 1 channel, as large as `grey` (an odd last row or column left out).
cv::Mat binariseDark(const cv::Mat& image, const QuadOptions& options);

/// Clockwise in the image, corners to about 0.3 px.
std::vector<Quad> findDarkQuads(const cv::Mat& grey, const QuadOptions& options = {});

}  // namespace facenav::tracking
