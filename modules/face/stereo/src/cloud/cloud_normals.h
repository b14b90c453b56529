#pragma once
// Surface normals from the disparity map.

#include "facenav/stereo/dense_matcher.h"

namespace facenav::stereo {

/// 32-bit, 3 channels: unit normal towards the camera, in the rectified frame, from a plane fitted to the
/// disparities of the surrounding disk (a plane in space is a plane in disparity); NaN where the disk
/// contains too few of them.
cv::Mat diskNormals(const Rectification& rectification, const DisparityMap& map);

}  // namespace facenav::stereo
