#pragma once
// MarkerSearch: from a marker detected in one image to poses worth fitting, and back: where a pose puts the
// markers in both images, and whether the images show them there.

#include <optional>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "marker_detection.h"
#include "marker_edges.h"

namespace facenav::coil_tracking {

/// What stays the same while one coil is tracked.
struct CoilSetup {
  cameras::StereoRig rig;
  CoilModel coil;
  std::vector<MarkerPattern> patterns;  // of coil.markers

  SeenMarker seen(std::size_t marker) const {
    const MarkerModel& model = coil.markers[marker];
    return {&patterns[marker], model.coil_T_marker, model.size_mm};
  }
};

using CoilToCamera = RigidTransform<Camera, Coil>;

constexpr double kLeastDepth_mm = 50.0;

/// Where the marker's corners appear; nothing when one is outside the image or the marker's back is turned.
/// `right_T_left`: of the rig, or as fitted.
std::optional<Quad> cornersInImage(const CoilSetup& setup, std::size_t marker,
                                   const Eigen::Isometry3d& camera_T_coil, bool is_left,
                                   const Eigen::Isometry3d& right_T_left);
/// Both poses that one image's square allows (the other image decides).
std::vector<CoilToCamera> posesFromOneImage(const CoilSetup& setup, const MarkerDetection& seen,
                                            bool is_left);
/// The markers whose corners both images should show at this pose.
std::vector<std::size_t> markersInView(const CoilSetup& setup, const CoilToCamera& camera_T_coil);
/// Whether both images show the marker's pattern where the fit puts it.
bool isReadInBoth(const CoilSetup& setup, const cameras::StereoFrame& frame, std::size_t marker,
                  const Eigen::Isometry3d& camera_T_coil, const Eigen::Isometry3d& right_T_left);
/// How far from its predicted place an edge can be told from the other edges of the print, px: 1.2 cells as
/// seen, 2..12.
int searchReach_px(const CoilSetup& setup, const std::vector<std::size_t>& markers,
                   const CoilToCamera& camera_T_coil);

}  // namespace facenav::coil_tracking
