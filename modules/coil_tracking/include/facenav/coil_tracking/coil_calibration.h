#pragma once
// Coil calibration: where the coil's contact face lies relative to its marker (marker_T_coil of coil.json),
// from poses of the marker, with residual and standard error. Two ways:
// - a jig that holds a second marker at a known place of the coil (coil_T_jig): both markers seen in some
// frames;
// - pivoting: the coil's contact centre, then a point on the handle, then a point on the right of the contact
// face
//   stand on a fixed tip each while the coil is turned about it. The first gives the origin, the others the
//   axes.

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/coil_tracking/coil_tracker.h"

namespace facenav::coil_tracking {

struct CoilCalibration {
  RigidTransform<Marker, Coil> marker_T_coil;
  std::string method;                  // "jig", "pivot"
  double rms_mm = 0;                   // of what was fitted, at the coil's origin or at the tips
  double sigma_mm = 0, sigma_deg = 0;  // standard errors of the coil's place and direction
  int frames = 0, used = 0;            // used: without outliers
};

struct JigSighting {
  RigidTransform<Camera, Marker> camera_T_marker, camera_T_jig;  // of the coil's marker and of the jig's
};
/// Throws Error with fewer than 5 frames that agree.
CoilCalibration calibrateWithJig(const std::vector<JigSighting>& sightings,
                                 const RigidTransform<Coil, Marker>& coil_T_jig);

/// The point of the marker's frame that stood still.
struct Pivot {
  Eigen::Vector3d in_marker_mm = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // mm^2
  double rms_mm = 0;                                     // of the tip over the used poses
  int poses = 0, used = 0;
};
/// Throws Error with fewer than 10 poses, or turned by less than 20 degrees about two axes.
Pivot fitPivot(const std::vector<RigidTransform<Camera, Marker>>& poses);
/// `handle`: any point on the coil's axis of symmetry on the handle's side; `side`: any point of the contact
/// face's plane on the side of +x, the left of one who holds the handle with the face down. Throws Error when
/// they lie in one line, or nearer than 20 mm to the centre.
CoilCalibration calibrateWithPivots(const Pivot& centre, const Pivot& handle, const Pivot& side);

/// coil.json with the calibration of its first marker and, as an addition, "calibration": {method, rms_mm,
/// sigma_mm, sigma_deg, frames}. A coil with several markers keeps their places relative to the first.
void writeCalibratedCoil(CoilModel coil, const CoilCalibration& calibration,
                         const std::filesystem::path& path);

}  // namespace facenav::coil_tracking
