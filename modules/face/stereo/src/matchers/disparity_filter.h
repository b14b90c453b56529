#pragma once
// Speckle removal after matching.

#include "facenav/stereo/dense_matcher.h"

namespace facenav::stereo {

/// Sets connected patches of fewer than `smallest` elements to NaN (32-bit float; neighbours are connected
/// when they differ by no more than `largest_step_px`).
void removeSpeckles(cv::Mat& disparity, int smallest, float largest_step_px);

/// The map without connected patches of fewer than `smallest_patch_px` pixels (neighbours within 1 px of
/// disparity).
DisparityMap withoutSpeckles(DisparityMap map, int smallest_patch_px);

}  // namespace facenav::stereo
