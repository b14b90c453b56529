#pragma once
// Does the calibration still hold? In a rectified pair matching points share a row; if the cameras have
// moved, they do not.

#include "facenav/stereo/face_cloud.h"

namespace facenav::stereo {

/// Median over the best-textured matches of |row difference|, px; 0 when there are fewer than 30 such
/// matches.
double epipolarMedian(const Rectification& rectification, const RectifiedPair& pair, const DisparityMap& map);

/// For a pair in which next to nothing matches: the whole number of rows by which the right image must be
/// moved for the most to match; 0 where no shift helps (no texture at all, or another scene).
double bestRowShift(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                    const FaceCloudOptions& options);

}  // namespace facenav::stereo
