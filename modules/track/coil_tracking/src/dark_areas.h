#pragma once
// Finds the dark areas of an image and their outlines (paper, section 5, steps 1 and 2). The threshold lies
// halfway between the darkest and brightest grey nearby, so that lamps and shadows have no effect. Flat areas
// are light. Outlines are followed pixel by pixel (Moore's neighbours; Gonzalez & Woods, "Digital Image
// Processing", section 11.1), holes left out. Own loops, because cv::erode, cv::resize, cv::compare and
// cv::findContours take four times as long, and this is most of the work for a lost coil.

#include <opencv2/core.hpp>
#include <vector>

namespace facenav::coil_tracking {

struct Darkness {
  int least_contrast_grey = 24;  // between darkest and brightest nearby
  double share = 0.5;            // dark part of the range from darkest to brightest, 0..1
};

/// 1 for dark pixels, else 0, with a rim of one pixel of 0. `grey`: 8-bit, 1 channel; an odd last row or
/// column is ignored. Result: 8-bit, (H + 2) x (W + 2).
cv::Mat darkAreas(const cv::Mat& grey, const Darkness& darkness);

using Outline = std::vector<cv::Point>;

struct Outlines {
  std::vector<Outline> areas;  // pixels of the areas' outer borders, clockwise on the image (y down)
  int points = 0;              // border points followed in total, a measure of the work
};

/// Outlines of the areas with at least `least_points` border points (8-connected). `areas`: from darkAreas();
/// overwritten.
Outlines outlinesOf(cv::Mat areas, std::size_t least_points);

}  // namespace facenav::coil_tracking
