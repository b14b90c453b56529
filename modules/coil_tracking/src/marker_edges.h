#pragma once
// MarkerEdges: the printed edges of a marker as both images show them, measured row by row against a
// predicted pose, and the least-squares equations for the pose and what disturbs it.
//
// Parameters, in this order: rotation (rad) and translation (mm) of the markers, increments in Camera about
// their centre; the print's size factor; per image, how far blur and gamma move an edge into the black (px);
// pitch and roll of the right camera since its calibration (rad, about the axis across the epipolar lines'
// own direction and about its optical axis). Yaw is left out: it cannot be told from the size of the print.

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

/// How edges are measured in one round.
struct EdgeSampling {
  int stride_px = 2;                        // every n-th row or column that an edge crosses
  bool is_outline_only = false;             // the square's four sides
  int search_px = 0;                        // > 0: the strongest step within it, instead of the exact place
  std::array<double, 2> blur_px{0.8, 0.8};  // of the edges, per image
};

/// One row's (or column's) crossing of one edge.
struct EdgeSample {
  int line;            // index of the edge and image it belongs to
  double t;            // 0..1 along the measured part of the edge
  double residual_px;  // along the normal into the black: measured - shrink - predicted
  double sigma_px;     // what noise and pixels leave
};

/// An edge in one image: derivative of its position along the normal, as a square function of t.
struct EdgeLine {
  int image;
  Eigen::Matrix<double, kFitParameters, 3> derivative;  // coefficients of 1, t, t^2
  int tried = 0, found = 0;
};

struct MarkerEdges {
  std::vector<EdgeLine> lines;
  std::vector<EdgeSample> samples;
  std::array<int, 2> tried{0, 0}, found{0, 0};
};

/// The pair that is looked at. `right_T_left` and cameras as calibrated.
struct EdgeView {
  const cameras::StereoRig& rig;
  const cameras::StereoFrame& frame;
};

/// Mean of the markers' centres, Camera.
Eigen::Vector3d centreOf(const std::vector<SeenMarker>& markers, const Eigen::Isometry3d& camera_T_coil);
/// The axis (RightCamera, unit) whose rotation moves the right image straight across the epipolar lines at
/// `centre_mm` (Camera).
Eigen::Vector3d pitchAxis(const cameras::StereoRig& rig, const Eigen::Vector3d& centre_mm);
/// right_T_left with the state's pitch and roll.
Eigen::Isometry3d rightFromLeft(const cameras::StereoRig& rig, const FitState& state,
                                const Eigen::Vector3d& centre_mm);

/// Measures all edges. `edges` is overwritten (its memory is used again).
void measureEdges(const EdgeView& view, const std::vector<SeenMarker>& markers, const FitState& state,
                  const EdgeSampling& sampling, MarkerEdges& edges);

}  // namespace facenav::coil_tracking
