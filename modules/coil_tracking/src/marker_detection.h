#pragma once
// Which of the coil's markers one image shows, and where (paper, section 5, steps 1 to 4). Quadrangles are
// sought in a smaller image (half of VGA: a quarter of the time, and noise is averaged away), patterns are
// read from the full one.

#include <opencv2/core.hpp>
#include <vector>

#include "marker_pattern.h"

namespace facenav::coil_tracking {

struct MarkerDetection {
  std::size_t marker;  // index into the patterns
  Quad corners;        // in the order of the print, from top left clockwise, to about 1 px
  PatternMatch match;
};

/// The light that a print is looked for in: dim, where its contrast is low. Either costs about the same.
enum class MarkerLight { bright, dim, bright_else_dim };

struct DetectedMarkers {
  std::vector<MarkerDetection> markers;
  int looks = 0;  // the work (frame_work.h)
};

/// All quadrangles of the image that show one of the patterns; the same place is given once.
DetectedMarkers detectMarkers(const cv::Mat& grey, const std::vector<MarkerPattern>& patterns,
                              MarkerLight light = MarkerLight::bright_else_dim);
/// Whether the quadrangle shows this pattern this way up: for a place that was predicted.
bool showsUpright(const cv::Mat& grey, const Quad& corners, const MarkerPattern& pattern);

}  // namespace facenav::coil_tracking
