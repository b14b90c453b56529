#pragma once
// StereoRig: two calibrated cameras (pinhole with OpenCV distortion, 4 to 14 coefficients), as in stereo.yml.
// x_right = R x_left + T is right_T_left. Pixels: (0, 0) is the centre of the top-left pixel, as in OpenCV.

#include <Eigen/Core>
#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "facenav/geometry/rigid_transform.h"

namespace facenav::cameras {

struct CameraModel {
  cv::Matx33d k = cv::Matx33d::eye();  // fx 0 cx; 0 fy cy; 0 0 1, px
  cv::Mat distortion;                  // 1 x n, 64-bit, n = 4, 5, 8, 12 or 14; empty: none
  /// Time from one row's exposure to that of the row below (rolling shutter), s. A picture's time stamp is
  /// that of its middle row. 0: all rows at once, or not known. Negative: read from below.
  double row_time_s = 0.0;
};

/// Longest readout time of a picture in any camera, s.
constexpr double kLongestReadout_s = 0.1;

struct StereoRig {
  int width_px = 0, height_px = 0;  // size of both images
  CameraModel left, right;
  RigidTransform<RightCamera, Camera> right_T_left;
  std::optional<double> rms_px;  // reprojection error of the calibration, where known
  /// Covariance of the calibration's parameters: n x n, 64-bit, in the order left fx fy cx cy and distortion,
  /// right likewise, increment of right_T_left (rotation rad, translation mm; applied on the left). Empty:
  /// unknown.
  cv::Mat covariance;

  double baseline_mm() const { return right_T_left.inverse().translation_mm().norm(); }
};

/// True for the same picture size, lenses and camera poses. Row times and standard errors may differ:
/// sessions measure row times anew.
bool isSameCalibration(const StereoRig& a, const StereoRig& b);

/// Reads stereo.yml (resources/doc/formats.md). Throws Error naming the file and the missing or malformed
/// key: K without positive focal lengths, R that is not a rotation, T of zero length or one that looks like
/// metres (< 5 mm), a row time with which a picture would take longer than kLongestReadout_s.
StereoRig readRig(const std::filesystem::path& path);
/// Writes the whole stereo.yml or nothing.
void writeRig(const StereoRig& rig, const std::filesystem::path& path);

/// Distorted pixel of a point in the camera's own frame (mm). z must be > 0.
Eigen::Vector2d project(const CameraModel& camera, const Eigen::Vector3d& p_mm);
/// Projects a point and gives the derivative d(pixel)/d(p), 2 x 3.
Eigen::Vector2d project(const CameraModel& camera, const Eigen::Vector3d& p_mm,
                        Eigen::Matrix<double, 2, 3>& jacobian);
/// Undistorted normalised coordinates (x/z, y/z) of a pixel.
Eigen::Vector2d undistort(const CameraModel& camera, const Eigen::Vector2d& pixel);

/// The point that minimises the reprojection error of both pixels (mid-point start, Gauss-Newton), in Camera.
Point<Camera> triangulate(const StereoRig& rig, const Eigen::Vector2d& left_px,
                          const Eigen::Vector2d& right_px);
/// Distance (px) of each pixel from the epipolar line of the other one; the larger of the two. A check of a
/// match.
double epipolarError_px(const StereoRig& rig, const Eigen::Vector2d& left_px,
                        const Eigen::Vector2d& right_px);

}  // namespace facenav::cameras
