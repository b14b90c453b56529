#pragma once
// CameraView: one camera's picture to draw on, with the camera's projection. Private to pictures.

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/guidance/target.h"

namespace facenav::pictures {

inline const cv::Scalar kBlue(84, 178, 255), kOrange(255, 160, 51), kGrey(175, 180, 188),
    kWhite(255, 255, 255), kDark(12, 14, 18);  // R, G, B

struct CameraView {
  cv::Mat image;  // 8-bit RGB
  const cameras::CameraModel* camera;
  Eigen::Isometry3d view_T_camera;
  double unit;  // scale of line widths and letters: 1 at 480 rows

  /// Projects a point; in 1/16 px, for cv's drawing with shift 4. Nothing if behind the camera or far
  /// outside.
  std::optional<cv::Point> toPixel(const Eigen::Vector3d& p_camera_mm) const;
  static cv::Point fixed(const Eigen::Vector2d& px);
  int thickness(double width) const;
};

/// Makes a view. `grey`: 8-bit, 1 channel.
CameraView makeView(const cv::Mat& grey, const cameras::CameraModel& camera,
                    const Eigen::Isometry3d& view_T_camera);
void polyline(CameraView& view, const std::vector<cv::Point>& points, bool is_closed,
              const cv::Scalar& colour, double width);
void drawLine(CameraView& view, const Eigen::Vector3d& a_mm, const Eigen::Vector3d& b_mm,
              const cv::Scalar& colour, double width);
/// Draws a ring on the skin and a line to the cortex.
void drawTarget(CameraView& view, const RigidTransform<Camera, Mri>& camera_T_mri,
                const guidance::Target& target);
/// Draws the coil's axis, from above the plate into the head.
void drawAxis(CameraView& view, const RigidTransform<Camera, Coil>& camera_T_coil);
/// Draws a dark band with words along the upper edge.
void drawCaption(CameraView& view, const std::string& words, bool is_lost);

}  // namespace facenav::pictures
