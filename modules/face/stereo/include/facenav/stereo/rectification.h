#pragma once
// Rectification: both images turned so that the baseline is their x axis and matching points share a row,
// whatever the relative pose of the cameras (side by side, one above the other, rolled, swapped: images are
// turned as needed). After Fusiello, Trucco, Verri 2000, and not cv::stereoRectify, which keeps a vertical
// pair vertical and crops by its own rules. Frame "rectified": origin of Camera, x along the baseline, z
// forward.
//
// Disparity of a point at depth z in that frame: x_left - x_right = f_px * baseline_mm / z_mm +
// disparity_offset_px.

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"

namespace facenav::stereo {

struct DepthRange {
  double nearest_mm = 300.0, farthest_mm = 1500.0;
};

struct Rectification {
  Eigen::Matrix3d rectified_R_camera = Eigen::Matrix3d::Identity();
  double f_px = 0, cx_left_px = 0, cx_right_px = 0, cy_px = 0, baseline_mm = 0;
  int disparities = 0;          // number of searched disparities: 0 .. disparities - 1
  cv::Mat left_map, right_map;  // 32-bit, 2 channels: the recorded pixel of each rectified one
  cv::Mat left_mask,
      right_mask;  // 8-bit: 255 if that pixel lies inside the image (and the region of interest)

  double offset_px() const { return cx_left_px - cx_right_px; }
  /// Point in Camera of a pixel of the rectified left image.
  Eigen::Vector3d point_mm(double x_px, double y_px, double disparity_px) const;
  /// Derivative d(z)/d(disparity) at that disparity, in the rectified frame.
  double depthPerDisparity_mm(double disparity_px) const;
};

/// Maps for the part of the left image inside `left_roi` (all of it if empty) over a depth range. The
/// rectified right image is `disparities` wider, so that no search leaves it. Throws Error if one camera is
/// positioned in front of the other, or if they do not face the same way.
Rectification rectify(const cameras::StereoRig& rig, const DepthRange& range, const cv::Rect& left_roi = {});

/// Both images at rectified pixels, 32-bit float (quintic B-splines).
struct RectifiedPair {
  cv::Mat left, right;
};

RectifiedPair applyRectification(const Rectification& rectification, const cameras::StereoFrame& frame);

}  // namespace facenav::stereo
