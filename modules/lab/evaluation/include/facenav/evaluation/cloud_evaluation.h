#pragma once
// Compares the face cloud with exact depth maps: error along the ray, and share of the visible face with
// points.

#include <opencv2/core.hpp>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/evaluation/run_record.h"
#include "facenav/stereo/face_cloud.h"

namespace facenav::evaluation {

/// Exact depth at the capture: mm along each camera's z at pixel centres (float; 0: no object), and the
/// pixels of the left image that show the head (8-bit).
struct ExactDepth {
  cv::Mat left_mm, right_mm, is_head_left;
};

/// Pixels of visible face (8-bit, left image): 255 for skin within `reach_mm` of the face's middle (Camera)
/// that both cameras see at less than 70 degrees from its normal and that is not at a silhouette (a neighbour
/// 2 px away is more than 8 mm nearer or farther).
cv::Mat visibleFace(const cameras::StereoRig& rig, const ExactDepth& depth, const Point<Camera>& face_middle,
                    double reach_mm = 75.0);

/// Compares a cloud with the exact depth. `face`: the measured cloud, each point at its pixel of the left
/// image.
CloudFigures evaluateCloud(const cameras::StereoRig& rig, const stereo::FaceCloud& face,
                           const ExactDepth& depth, const cv::Mat& visible);

}  // namespace facenav::evaluation
