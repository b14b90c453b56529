#pragma once
// Sharpness of the face's image; defocus and motion reduce it.

#include <optional>

#include "image_pyramid.h"

namespace facenav::head_tracking {

/// Fine detail of the contrast in `box` (full resolution): rms of level 1 minus its 3 x 3 mean, relative to
/// the rms of 3 x 3 minus 9 x 9 means; the sensor's noise (`noise_grey`) is subtracted. Empty if the box is
/// too small.
std::optional<double> fineDetail(const ImagePyramid& image, const cv::Rect& box, double noise_grey);

}  // namespace facenav::head_tracking
