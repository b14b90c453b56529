#pragma once
// What is taken out of a disparity map after matching.

#include "facenav/stereo/dense_matcher.h"

namespace facenav::stereo {

/// The map without connected patches of fewer than `smallest_patch_px` pixels (neighbours within 1 px of
/// disparity).
DisparityMap withoutSpeckles(DisparityMap map, int smallest_patch_px);

}  // namespace facenav::stereo
