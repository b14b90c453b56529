#pragma once
// The pose of a board that fits both images best: what tells the error of a rig on a view, seen or held out.

#include "facenav/cameras/calibrate.h"

namespace facenav::cameras {

struct ViewFit {
  Eigen::Isometry3d camera_T_board = Eigen::Isometry3d::Identity();
  double left_rms_px = 0, right_rms_px = 0;
  /// Of both sides together.
  double rms_px() const { return std::sqrt(0.5 * (left_rms_px * left_rms_px + right_rms_px * right_rms_px)); }
};

/// One image's board pose by cv::solvePnP: a start.
Eigen::Isometry3d solveBoardPose(const CameraModel& camera, const std::vector<cv::Point3f>& points,
                                 const std::vector<cv::Point2f>& corners);

/// Least squares over both images, 6 degrees of freedom. Start: cv::solvePnP in the left image.
ViewFit fitBoard(const StereoRig& rig, const BoardView& view, const Board& board);

}  // namespace facenav::cameras
