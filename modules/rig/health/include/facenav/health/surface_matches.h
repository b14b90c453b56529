#pragma once
// Points of a measured surface, matched again in a pair of pictures: observations of the right camera's pose.

#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/point.h"
#include "facenav/health/observation.h"

namespace facenav::health {

/// Matches `surface` (Camera, mm, with its pixels in the left image): at most `most` matches, spread over the
/// surface.
std::vector<Correspondence> matchSurface(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                                         const PointCloud<Camera>& surface,
                                         const std::vector<Eigen::Vector2f>& left_px, std::size_t most = 600);

/// Outline of a surface in the left image, px: the convex hull of its pixels; empty without a surface.
std::vector<cv::Point> outlineOf(const std::vector<Eigen::Vector2f>& left_px);

}  // namespace facenav::health
