#pragma once
// The depth error that all points of a face share, from calibration and matching. It does not show in an
// alignment's residuals, so the alignment's error bound must include it.

#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/point.h"
#include "facenav/registration/aligner.h"
#include "facenav/stereo/face_cloud.h"

namespace facenav::measured_face {

/// Standard error (mm) of the shared depth error of a face measured with `rig`, in Camera. It comes from the
/// covariance of the rig's calibration if its file has one, else from the error of a good calibration (0.02
/// px). 0 for no points.
double sharedDepthSigma_mm(const cameras::StereoRig& rig, const PointCloud<Camera>& face);

/// What the points of a measured face are off alike, for the alignment's bound: by the deviation that the
/// cloud states (stereo/shared_error.h), and by the calibration.
struct FaceError {
  double whole_mm = 0.0;           // all of the face, along the view
  registration::SightError sight;  // neighbours
};
FaceError faceErrorOf(const cameras::StereoRig& rig, const stereo::FaceCloud& face);

}  // namespace facenav::measured_face
