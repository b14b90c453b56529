#pragma once
// Dark quadrangles on a light background (paper, section 5, step 3): dark areas (dark_areas.h) with four
// corners.

#include <opencv2/core.hpp>
#include <vector>

#include "dark_areas.h"
#include "marker_pattern.h"

namespace facenav::coil_tracking {

struct FoundQuads {
  std::vector<Quad> quads;  // clockwise in the image, corners to about 0.3 px
  int points = 0;           // outline points followed in total, a measure of the work
};

FoundQuads findDarkQuads(const cv::Mat& grey, const Darkness& darkness = {}, double least_side_px = 6.0);

}  // namespace facenav::coil_tracking
