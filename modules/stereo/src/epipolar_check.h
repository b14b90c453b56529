#pragma once
// Does the calibration still hold? In a rectified pair matching points share a row; if the cameras have
// moved, they do not.

#include "facenav/stereo/dense_matcher.h"

namespace facenav::stereo {

/// Median over the best-textured matches of |row difference|, px; 0 when there are fewer than 30 such
/// matches.
double epipolarMedian(const Rectification& rectification, const RectifiedPair& pair, const DisparityMap& map);

}  // namespace facenav::stereo
