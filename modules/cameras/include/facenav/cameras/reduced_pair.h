#pragma once
// Pictures and cameras at a half, a quarter, .. of their size. Plain skin has a coarse texture; it is matched
// better in smaller pictures, since the matcher's window then holds more of it.

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"

namespace facenav::cameras {

/// How many times smaller pictures may be that show `depth_mm` with at least `least_px_per_mm`: 1, 2, 4, 8.
int reductionFor(const StereoRig& rig, double depth_mm, double least_px_per_mm);

/// The same cameras with pixels `times` as large (their covariance is left out). Rows and columns that fill
/// no pixel are cut off.
StereoRig reduced(const StereoRig& rig, int times);
StereoFrame reduced(const StereoFrame& frame, int times);

/// A pixel of the reduced picture, in the whole one.
Eigen::Vector2f inWholePicture(const Eigen::Vector2f& reduced_px, int times);

}  // namespace facenav::cameras
