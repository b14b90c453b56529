#pragma once
// Points of a measured surface, matched again in a pair of pictures: observations of the right camera's pose.

#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/point.h"
#include "facenav/health/observation.h"

namespace facenav::health {

/// Matches the part of `surface` (Camera, mm, with its pixels in the left image) inside the outline (px, left
/// image): some hundred matches, spread over it.
std::vector<Correspondence> matchSurface(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                                         const PointCloud<Camera>& surface,
                                         const std::vector<Eigen::Vector2f>& left_px,
                                         const std::vector<cv::Point>& outline);

/// True if a pixel of the left image lies inside the outline, or the outline is empty.
bool isInside(const std::vector<cv::Point>& outline, const Eigen::Vector2d& left_px);

/// Outline of a surface in the left image, px: the convex hull of its pixels; empty without a surface.
std::vector<cv::Point> outlineOf(const std::vector<Eigen::Vector2f>& left_px);

}  // namespace facenav::health
