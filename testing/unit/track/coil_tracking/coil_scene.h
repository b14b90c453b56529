#pragma once
// A stereo pair of a printed marker with exact truth: every pixel is the mean of 25 rays to the plane of the
// print, then blur, camera gamma and noise. The only code in common with the tracker is the camera model's
// undistort().

#include <opencv2/core.hpp>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"

namespace facenav::coil_tracking::testing {

/// The print as cells with light 0..1, in the black square (-.5..+.5 of its side).
using Print = cv::Mat_<float>;  // cells of the square, border included; white around it

/// The print of an ArUco marker.
Print arucoPrint(int predefined_dictionary, int id);
/// Exchanges left and right of the print, as in a mirror.
Print mirrored(const Print& print);

struct PlacedPrint {
  Print print;
  double size_mm = 60.0;
  RigidTransform<Camera, Marker> camera_T_marker;
  double margin_cells = 1.0;                              // white around the square
  Eigen::Vector3d moving_mm_s = Eigen::Vector3d::Zero();  // Camera; cameras with a row time see it sheared

  /// Pose of the print when the camera exposes this row.
  Eigen::Isometry3d inRow(double row, const cameras::CameraModel& camera, int rows) const {
    Eigen::Isometry3d pose = camera_T_marker.isometry();
    pose.translation() += camera.row_time_s * (row - 0.5 * (rows - 1)) * moving_mm_s;
    return pose;
  }
};

struct SceneOptions {
  double white_grey = 200, black_grey = 25, ground_grey = 90;
  double blur_sigma_px = 0.7, gamma = 1.0, noise_grey = 1.5;
  double side_light = 0.0;  // relative change of grey from the left to the right edge of the image
  double shadow_from_x = 1e9,
         shadow_factor = 1;  // pixels right of this column receive this fraction of the light
  bool has_clutter = true;   // random dark shapes on the ground
  unsigned seed = 1;
};

cameras::StereoFrame renderMarkers(const cameras::StereoRig& rig, const std::vector<PlacedPrint>& prints,
                                   const SceneOptions& options = {});

/// The room's two cameras: f 800 px at 640 x 480, baseline 120 mm, converging by 10 degrees, with distortion.
cameras::StereoRig roomRig();
/// Another rig: 1000 x 750, f 1150, baseline 180 mm rolled by 80 degrees (nearly vertical), rational model.
cameras::StereoRig steepRig();

/// Pose of a marker facing the rig at `distance_mm`: tilted about an axis in its plane at `axis_deg`, rotated
/// in its plane by `turn_deg`, shifted sideways by `side_mm`.
RigidTransform<Camera, Marker> markerPose(double distance_mm, double tilt_deg, double axis_deg,
                                          double turn_deg, const Eigen::Vector2d& side_mm = {0, 0});

}  // namespace facenav::coil_tracking::testing
