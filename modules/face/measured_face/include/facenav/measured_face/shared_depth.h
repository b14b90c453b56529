#pragma once
// Depth error that all points of a face share, from calibration and matching. An alignment's residuals do not
// show it, so its error bound must include it.

#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/point.h"
#include "facenav/registration/aligner.h"
#include "facenav/stereo/face_cloud.h"

namespace facenav::measured_face {

/// Standard error (mm) of the shared depth error of a face measured with `rig`, in Camera. It follows from
/// the covariance in the rig's calibration file, or else from the error of a good calibration (0.02 px). 0
/// without points.
double sharedDepthSigma_mm(const cameras::StereoRig& rig, const PointCloud<Camera>& face);

/// Errors of a measured face's points, for the alignment and its bound. Sources: the cloud's predicted
/// deviation (stereo/shared_error.h) and the calibration.
struct FaceError {
  double whole_mm = 0.0;           // shared by the whole face, along the view
  registration::SightError sight;  // shared by neighbouring points
  double point_mm = 0.0;           // of single points, as the cloud states it
};
FaceError faceErrorOf(const cameras::StereoRig& rig, const stereo::FaceCloud& face);

}  // namespace facenav::measured_face
