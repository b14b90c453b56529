#pragma once
// Pictures and cameras at a half, a quarter, .. of their size. Plain skin has a coarse texture; it is matched
// better in smaller pictures, since the matcher's window then covers more of it.

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"

namespace facenav::cameras {

/// The largest reduction (1, 2, 4, 8) at which the images still show `depth_mm` with `least_px_per_mm`.
int reductionFor(const StereoRig& rig, double depth_mm, double least_px_per_mm);

/// Rig with pixels `times` as large, without covariance. Rows and columns that do not fill a pixel are cut
/// off.
StereoRig reduced(const StereoRig& rig, int times);
StereoFrame reduced(const StereoFrame& frame, int times);

/// Position in the whole image of a pixel of the reduced image.
Eigen::Vector2f inWholePicture(const Eigen::Vector2f& reduced_px, int times);

}  // namespace facenav::cameras
