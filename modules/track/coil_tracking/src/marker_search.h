#pragma once
// MarkerSearch: from a marker detected in one image to candidate poses; and from a pose to the markers'
// corners in both images, with a check that the images show them there.

#include <optional>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "marker_detection.h"
#include "marker_edges.h"

namespace facenav::coil_tracking {

/// Input of a fit besides the frame. Only the motion, and the rig if a camera moves, change while one coil is
/// tracked.
struct CoilSetup {
  cameras::StereoRig rig;
  CoilModel coil;
  std::vector<MarkerPattern> patterns;  // one per marker of coil.markers
  CoilMotion motion = {};               // while the frame is read; changes from frame to frame

  SeenMarker seen(std::size_t marker) const {
    const MarkerModel& model = coil.markers[marker];
    return {&patterns[marker], model.coil_T_marker, model.size_mm};
  }
};

using CoilToCamera = RigidTransform<Camera, Coil>;

constexpr double kLeastDepth_mm = 50.0;

/// Corners of the marker in the image. Returns nothing if one is outside, or if the marker faces away.
/// `right_T_left`: of the rig, or as fitted.
std::optional<Quad> cornersInImage(const CoilSetup& setup, std::size_t marker,
                                   const Eigen::Isometry3d& camera_T_coil, bool is_left,
                                   const Eigen::Isometry3d& right_T_left);
/// Both poses that a square in one image allows; the other image shows which is right.
std::vector<CoilToCamera> posesFromOneImage(const CoilSetup& setup, const MarkerDetection& seen,
                                            bool is_left);
/// Start states if both images show the marker `seen` in one of them, but its size or rows contradict the
/// calibration too much for a fit from `poses` (those of the one image), because a camera has turned. They
/// are these poses at the distance that both images show, with the size and pitch that then fit. Else empty.
std::vector<FitState> statesFromBothImages(const CoilSetup& setup, const MarkerDetection& seen, bool is_left,
                                           const Quad& in_other, const std::vector<CoilToCamera>& poses);
/// The markers whose corners should appear in both images at this pose.
std::vector<std::size_t> markersInView(const CoilSetup& setup, const CoilToCamera& camera_T_coil);
/// True if both images show the marker's pattern at the fitted pose.
bool isReadInBoth(const CoilSetup& setup, const cameras::StereoFrame& frame, std::size_t marker,
                  const Eigen::Isometry3d& camera_T_coil, const Eigen::Isometry3d& right_T_left);
/// Search distance for an edge without risk of taking another edge of the print, px: 1.2 cells in the image,
/// limited to 2..12.
int searchReach_px(const CoilSetup& setup, const std::vector<std::size_t>& markers,
                   const CoilToCamera& camera_T_coil);

}  // namespace facenav::coil_tracking
