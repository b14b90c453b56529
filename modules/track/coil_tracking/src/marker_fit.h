#pragma once
// MarkerFit: one pose from the printed edges in both images (paper, section 5). Instead of triangulating
// corners, it minimises the reprojection error of all black/white edges, outer and inner, at once. Free
// parameters besides the six of the pose:
// - the print's size and, per image, how far blur and gamma move an edge into the black (0.2-0.5 px in
//   practice). Stereo alone then determines the depth; print size and exposure cannot shift it;
// - pitch and roll of the right camera, to check whether the calibration still holds. They are measured
//   freely; then the pose is conditioned on the calibration's values.

#include <array>
#include <optional>
#include <vector>

#include "facenav/core/frame_work.h"
#include "marker_edges.h"

namespace facenav::coil_tracking {

/// Observation of the row times of left and right camera by one frame of a moving coil: their difference from
/// those of the rig, as normal equations. It includes the uncertainty of all free parameters of the fit.
struct RowTimeEquations {
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();  // 1/s^2
  Eigen::Vector2d right = Eigen::Vector2d::Zero();        // information * correction, 1/s
};

/// Prior of how far blur and gamma move an edge, standard deviation.
constexpr double kShrinkSigma_px = 0.5, kTurnSigma_rad = 0.02;

struct MarkerFit {
  RigidTransform<Camera, Coil> camera_T_coil;
  Matrix6d covariance;        // (rad, mm), increment in Camera about `centre_mm`
  Eigen::Vector3d centre_mm;  // mean of the markers' centres, Camera
  double rms_px = 0;          // of inlier edge points, normal to the edge
  double bias_px =
      0;  // rms of the mean residuals of all edges in both images: misfit that noise cannot explain
  double inlier_fraction = 0;  // inliers among the attempted edge points, in the worse image
  int points = 0;
  double size_factor = 1, size_sigma = 0;     // fitted size of the print / nominal
  std::array<double, 2> shrink_px{0, 0};      // shift of edges into the black
  double pitch_rad = 0, pitch_sigma_rad = 0;  // pitch of the right camera since its calibration
  double roll_rad = 0, roll_sigma_rad = 0;    // measured from this marker alone
  FitState free_state;                        // with that pitch and roll, before conditioning
  RowTimeEquations row_times;                 // zero for a resting coil
};

struct FitStart {
  FitState state;
  int search_px = 3;  // distance within which edges are searched
};

/// Result of the fit to the outlines alone.
struct OutlineFit {
  FitState state;
  double spread = 0;  // spread of the outlines' residuals before the last step, in their sigmas
};

/// Fits the outlines near `start`. Returns nothing if either image shows too little of them.
std::optional<OutlineFit> fitOutlines(const EdgeView& view, const std::vector<SeenMarker>& markers,
                                      const FitStart& start, FrameWork& work);
/// Fits all edges; `start` must be within about 1 px. Returns nothing if either image shows too few.
std::optional<MarkerFit> fitMarkers(const EdgeView& view, const std::vector<SeenMarker>& markers,
                                    const FitState& start, FrameWork& work);

}  // namespace facenav::coil_tracking
