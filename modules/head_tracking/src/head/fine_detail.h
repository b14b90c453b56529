#pragma once
// How sharp the picture of the face is: what defocus and motion take away.

#include <optional>

#include "image_pyramid.h"

namespace facenav::head_tracking {

/// How much of the contrast in `box` (full resolution) is fine detail: that between level 1 and its 3 x 3
/// mean, by that between 3 x 3 and 9 x 9 means, the sensor's noise (`noise_grey`) taken off. Nothing where
/// the box is too small.
std::optional<double> fineDetail(const ImagePyramid& image, const cv::Rect& box, double noise_grey);

}  // namespace facenav::head_tracking
