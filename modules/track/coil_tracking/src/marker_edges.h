#pragma once
// MarkerEdges: the printed edges of a marker in both images, measured row by row near a predicted pose, and
// the least-squares equations for the pose and the disturbances.
//
// Parameters, in this order: rotation (rad) and translation (mm) of the markers, increments in Camera about
// their centre; the size factor of the print; per image, how far blur and gamma move an edge into the black
// (px); pitch and roll of the right camera since its calibration (rad; pitch about the axis that moves the
// image across the epipolar lines, roll about the optical axis). Yaw is left out: it cannot be separated from
// the size of the print.

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/rotation.h"
#include "marker_pattern.h"

namespace facenav::coil_tracking {

constexpr int kFitParameters = 11;
constexpr int kSize = 6, kShrink = 7, kPitch = 9, kRoll = 10;
using FitVector = Eigen::Matrix<double, kFitParameters, 1>;
using FitMatrix = Eigen::Matrix<double, kFitParameters, kFitParameters>;

/// A marker that both images show.
struct SeenMarker {
  const MarkerPattern* pattern;
  RigidTransform<Coil, Marker> coil_T_marker;
  double size_mm;
};

struct FitState {
  Eigen::Isometry3d camera_T_coil = Eigen::Isometry3d::Identity();
  double size_factor = 1.0;
  std::array<double, 2> shrink_px{0.0, 0.0};
  double pitch_rad = 0.0, roll_rad = 0.0;
};

/// Method of measuring edges in one round.
struct EdgeSampling {
  int stride_px = 2;             // every n-th row or column that crosses an edge
  bool is_outline_only = false;  // only the square's four sides
  int search_px = 0;  // > 0: finds the strongest step within this distance; 0: measures the exact place
  std::array<double, 2> blur_px{0.8, 0.8};  // of the edges, per image
};

/// One row's (or column's) crossing of one edge.
struct EdgeSample {
  int line;            // index into MarkerEdges::lines
  double t;            // 0..1 along the measured part of the edge
  double residual_px;  // along the normal into the black: measured - shrink - predicted
  double sigma_px;     // from noise and pixel size
};

/// An edge in one image. The derivative of its position along the normal is a quadratic function of t.
struct EdgeLine {
  int image;
  Eigen::Matrix<double, kFitParameters, 3> derivative;  // coefficients of 1, t, t^2
  Eigen::Vector3d by_row_time =
      Eigen::Vector3d::Zero();  // derivative by the image's row time, px/s, as coefficients of 1, t, t^2
  int tried = 0, found = 0;
};

struct MarkerEdges {
  std::vector<EdgeLine> lines;
  std::vector<EdgeSample> samples;
  std::array<int, 2> tried{0, 0}, found{0, 0};
};

/// Motion of the coil while a picture is read row by row.
struct CoilMotion {
  Vector6d velocity = Vector6d::Zero();  // (rad/s, mm/s), Camera, of the coil's origin
  bool isResting() const { return velocity.isZero(); }
};

/// The stereo frame that is measured, with `right_T_left` and cameras as calibrated. The state's pose is that
/// of the middle row. A camera with a row time sees the other rows at the coil's pose moved by `motion`.
struct EdgeView {
  const cameras::StereoRig& rig;
  const cameras::StereoFrame& frame;
  CoilMotion motion = {};
};

/// Mean of the markers' centres, Camera.
Eigen::Vector3d centreOf(const std::vector<SeenMarker>& markers, const Eigen::Isometry3d& camera_T_coil);
/// Axis (RightCamera, unit vector) whose rotation moves the right image of `centre_mm` (Camera) straight
/// across the epipolar lines.
Eigen::Vector3d pitchAxis(const cameras::StereoRig& rig, const Eigen::Vector3d& centre_mm);
/// right_T_left with the state's pitch and roll.
Eigen::Isometry3d rightFromLeft(const cameras::StereoRig& rig, const FitState& state,
                                const Eigen::Vector3d& centre_mm);

/// Measures all edges. Overwrites `edges`, whose memory is reused.
void measureEdges(const EdgeView& view, const std::vector<SeenMarker>& markers, const FitState& state,
                  const EdgeSampling& sampling, MarkerEdges& edges);

}  // namespace facenav::coil_tracking
