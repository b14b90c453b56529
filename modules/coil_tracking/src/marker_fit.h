#pragma once
// MarkerFit: one pose from the printed edges in both images (paper, section 5; instead of triangulated
// corners, the reprojection error of all black/white edges, outer and inner, is minimised at once). Free
// besides the six degrees of freedom: the print's size and, per image, how far blur and gamma move an edge
// into the black (0.2-0.5 px in practice), so that stereo sets the depth and neither the print nor the
// exposure can move it; and pitch and roll of the right camera, which tell whether the calibration still
// holds. Pitch and roll are measured freely, then the pose is conditioned on what the calibration says of
// them.

#include <array>
#include <optional>
#include <vector>

#include "facenav/core/frame_work.h"
#include "marker_edges.h"

namespace facenav::coil_tracking {

struct MarkerFit {
  RigidTransform<Camera, Coil> camera_T_coil;
  Matrix6d covariance;        // (rad, mm), increment in Camera about `centre_mm`
  Eigen::Vector3d centre_mm;  // mean of the markers' centres, Camera
  double rms_px = 0;          // of the inlying edge points, normal to the edge
  double bias_px = 0;  // rms of the mean residuals of all edges in both images: the misfit noise cannot make
  double inlier_fraction = 0;  // of the edge points that were tried, the worse image
  int points = 0;
  double size_factor = 1, size_sigma = 0;     // fitted size of the print / nominal
  std::array<double, 2> shrink_px{0, 0};      // edge moved into the black
  double pitch_rad = 0, pitch_sigma_rad = 0;  // of the right camera since its calibration,
  double roll_rad = 0, roll_sigma_rad = 0;    // as this marker alone tells them
  FitState free_state;                        // with that pitch and roll: what both images show
};

struct FitStart {
  RigidTransform<Camera, Coil> camera_T_coil;
  int search_px = 3;  // how far off its edges may lie
};

/// After the outlines alone.
struct OutlineFit {
  FitState state;
  double spread = 0;  // of the outlines' points about the fit before, in units of their sigma
};

/// The outlines, sought round `start`; nothing where too little of them is found in either image.
std::optional<OutlineFit> fitOutlines(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                                      const std::vector<SeenMarker>& markers, const FitStart& start,
                                      FrameWork& work);
/// All edges, from within about 1 px. Nothing where too few are found in either image.
std::optional<MarkerFit> fitMarkers(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                                    const std::vector<SeenMarker>& markers, const FitState& start,
                                    FrameWork& work);

}  // namespace facenav::coil_tracking
