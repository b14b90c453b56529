#pragma once
// Coil calibration: the pose of the coil's contact face relative to its marker (marker_T_coil of coil.json),
// from poses of the marker, with residual and standard error. Two ways:
// - jig: it has a second marker at a known place of the coil (coil_T_jig). Some frames show both markers;
// - pivot: a point of the coil rests on a fixed tip while the coil is turned about it. Three such points:
//   the contact centre gives the origin; a point on the handle and a point on the right of the contact face
//   give the axes.

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/coil_tracking/coil_tracker.h"

namespace facenav::coil_tracking {

struct CoilCalibration {
  RigidTransform<Marker, Coil> marker_T_coil;
  std::string method;                  // "jig", "pivot"
  double rms_mm = 0;                   // of the fitted points: the coil's origin (jig) or the tips (pivot)
  double sigma_mm = 0, sigma_deg = 0;  // standard errors of the coil's position and direction
  int frames = 0, used = 0;            // frames given; used without outliers
  std::string utc = {};                // time of the calibration; empty: unknown
};

struct JigObservation {
  RigidTransform<Camera, Marker> camera_T_marker,
      camera_T_jig;  // poses of the coil's marker and of the jig's
};
/// Throws Error if fewer than 5 frames agree.
CoilCalibration calibrateWithJig(const std::vector<JigObservation>& observations,
                                 const RigidTransform<Coil, Marker>& coil_T_jig);

/// The fixed point in the marker's frame.
struct Pivot {
  Eigen::Vector3d in_marker_mm = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // mm^2
  double rms_mm = 0;                                     // residual of the tip over the used poses
  int poses = 0, used = 0;
};
/// Throws Error with fewer than 10 poses, or if they turn by less than 20 degrees about two axes.
Pivot fitPivot(const std::vector<RigidTransform<Camera, Marker>>& poses);
/// `handle`: any point on the coil's axis of symmetry, on the handle's side. `side`: any point in the plane
/// of the contact face on the side of +x (to the left of a person who holds the handle with the face down).
/// Throws Error if the three points lie on one line, or one is nearer than 20 mm to the centre.
CoilCalibration calibrateWithPivots(const Pivot& centre, const Pivot& handle, const Pivot& side);

/// Writes coil.json with the new pose of its first marker and the additional key "calibration": {method, utc,
/// rms_mm, sigma_mm, sigma_deg, frames}. Further markers keep their poses relative to the first. All other
/// keys of `source`, the coil's previous file (empty: none), are kept.
void writeCalibratedCoil(CoilModel coil, const CoilCalibration& calibration,
                         const std::filesystem::path& path, const std::filesystem::path& source = {});

}  // namespace facenav::coil_tracking
