#pragma once
// The face cloud against exact depth maps: error along the ray, and how much of the visible face it covers.

#include <opencv2/core.hpp>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/evaluation/run_record.h"
#include "facenav/stereo/face_cloud.h"

namespace facenav::evaluation {

/// Exact depth at the capture: mm along each camera's z at pixel centres (float, 0: nothing there), and where
/// the left image shows the head (8-bit).
struct ExactDepth {
  cv::Mat left_mm, right_mm, is_head_left;
};

/// 8-bit, left image: 255 where skin within `reach_mm` of the face's middle (Camera) is seen by both cameras
/// at less than 70 degrees from its normal and does not lie at a silhouette (a neighbour 2 px away is more
/// than 8 mm nearer or farther).
cv::Mat visibleFace(const cameras::StereoRig& rig, const ExactDepth& depth, const Point<Camera>& face_middle,
                    double reach_mm = 75.0);

/// `face` as measured, each point at its pixel of the left image.
CloudFigures evaluateCloud(const cameras::StereoRig& rig, const stereo::FaceCloud& face,
                           const ExactDepth& depth, const cv::Mat& visible);

}  // namespace facenav::evaluation
