#pragma once
// Checks the calibration. In a rectified pair matching points lie in the same row, unless the cameras have
// moved.

#include <optional>

#include "facenav/stereo/face_cloud.h"

namespace facenav::stereo {

/// Median |row difference| of the best-textured matches, px; empty with fewer than 30 of them.
std::optional<double> epipolarMedian(const Rectification& rectification, const RectifiedPair& pair,
                                     const DisparityMap& map);

/// The row shift of the right image, in whole rows, that gives the most matches. Used for a pair with almost
/// no matches. 0 if no shift helps (no texture, or another scene).
double bestRowShift(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                    const FaceCloudOptions& options);

}  // namespace facenav::stereo
