#pragma once
// MarkerFit: one pose from the printed edges in both images (paper, section 5; instead of triangulated
// corners, the reprojection error of all black/white edges is minimised at once). Free besides the six
// degrees of freedom: the print's size (1 %) and, per image, how far blur and gamma move an edge into the
// black (0.2-0.5 px in practice); so stereo sets the depth and neither the print nor the exposure can move
// it.

#include <optional>
#include <vector>

#include "facenav/geometry/rotation.h"
#include "facenav/stereo/stereo_frame.h"
#include "facenav/stereo/stereo_rig.h"
#include "marker_pattern.h"

namespace facenav::tracking {

/// A marker that both images show.
struct SeenMarker {
  const MarkerPattern* pattern;
  RigidTransform<Coil, Marker> coil_T_marker;
  double size_mm;
};

struct MarkerFit {
  RigidTransform<Camera, Coil> camera_T_coil;
  Matrix6d covariance;        // (rad, mm), increment in Camera about `centre_mm`
  Eigen::Vector3d centre_mm;  // mean of the markers' centres, Camera
  double rms_px = 0;          // of the inlying edge points, normal to the edge
  double bias_px = 0;  // rms of the mean residuals of all sides in both images: the misfit noise cannot make
  double inlier_fraction = 0;  // of the edge points that were tried, the worse image
  int points = 0;
  double size_factor = 1;                          // fitted size of the print / nominal
  double shrink_left_px = 0, shrink_right_px = 0;  // edge moved into the black
};

/// From a start good to about 2 px. Nothing where too few edges are found in either image.
std::optional<MarkerFit> fitMarkers(const stereo::StereoRig& rig, const stereo::StereoFrame& frame,
                                    const std::vector<SeenMarker>& markers,
                                    const RigidTransform<Camera, Coil>& start);

}  // namespace facenav::tracking
