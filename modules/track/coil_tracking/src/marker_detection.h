#pragma once
// Detects the coil's markers in one image (paper, section 5, steps 1 to 4). Quadrangles are searched in a
// smaller image (half of VGA: a quarter of the time and less noise); patterns are read from the full one.

#include <opencv2/core.hpp>
#include <vector>

#include "marker_pattern.h"

namespace facenav::coil_tracking {

struct MarkerDetection {
  std::size_t marker;  // index into the patterns
  Quad corners;        // in the order of the print, clockwise from top left, to about 1 px
  PatternMatch match;
};

/// Work to match one pattern in one image, in patch comparisons (frame_work.h).
constexpr int kMatchComparisons = 20;

/// The expected light. `dim` finds prints of low contrast. Each costs about the same.
enum class MarkerLight { bright, dim, bright_else_dim };

struct DetectedMarkers {
  std::vector<MarkerDetection> markers;
  int comparisons = 0;  // work in patch comparisons (frame_work.h)
};

/// All quadrangles of the image that show one of the patterns, each place once.
DetectedMarkers detectMarkers(const cv::Mat& grey, const std::vector<MarkerPattern>& patterns,
                              MarkerLight light = MarkerLight::bright_else_dim);
/// True if the quadrangle shows this pattern the right way up. Used at predicted places.
bool showsUpright(const cv::Mat& grey, const Quad& corners, const MarkerPattern& pattern);

}  // namespace facenav::coil_tracking
