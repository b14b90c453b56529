#pragma once
// Dark quadrangles on light ground (paper, section 5, step 3): those dark areas (dark_areas.h) that have four
// corners.

#include <opencv2/core.hpp>
#include <vector>

#include "dark_areas.h"
#include "marker_pattern.h"

namespace facenav::coil_tracking {

struct FoundQuads {
  std::vector<Quad> quads;  // clockwise in the image, corners to about 0.3 px
  int points = 0;           // of the outlines that were followed: the work
};

FoundQuads findDarkQuads(const cv::Mat& grey, const Darkness& darkness = {}, double least_side_px = 6.0);

}  // namespace facenav::coil_tracking
