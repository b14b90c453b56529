#pragma once
// Checks the calibration: in a rectified pair matching points lie in the same row, unless the cameras have
// moved.

#include <optional>

#include "facenav/stereo/face_cloud.h"

namespace facenav::stereo {

/// Median over the best-textured matches of |row difference|, px; nothing with fewer than 30 such matches.
std::optional<double> epipolarMedian(const Rectification& rectification, const RectifiedPair& pair,
                                     const DisparityMap& map);

/// For a pair with almost no matches: the row shift of the right image, in whole rows, that gives the most
/// matches. 0 where no shift helps (no texture at all, or another scene).
double bestRowShift(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                    const FaceCloudOptions& options);

}  // namespace facenav::stereo
