#pragma once
// The board's pose that fits both images best. It determines the error of a rig on a view, used or held out.

#include "facenav/cameras/calibrate.h"

namespace facenav::cameras {

struct ViewFit {
  Eigen::Isometry3d camera_T_board = Eigen::Isometry3d::Identity();
  double left_rms_px = 0, right_rms_px = 0;
  /// Rms of both sides together.
  double rms_px() const { return std::sqrt(0.5 * (left_rms_px * left_rms_px + right_rms_px * right_rms_px)); }
};

/// Start value: the board's pose in one image, by cv::solvePnP.
Eigen::Isometry3d solveBoardPose(const CameraModel& camera, const std::vector<cv::Point3f>& points,
                                 const std::vector<cv::Point2f>& corners);

/// Fits the board to both images by least squares, 6 degrees of freedom. Start: cv::solvePnP in the left
/// image.
ViewFit fitBoard(const StereoRig& rig, const BoardView& view, const Board& board);

}  // namespace facenav::cameras
