#pragma once
// PatchObservation: information of one patch's displacements about the pose. There are two kinds of errors.
// Errors of shape, and light that stays with the lamps while the skin turns, displace the patch in both
// images alike; they are three to five times as large as all others. Noise and sampling are independent in
// each image. So the two displacements are converted to their mean, which contains the common error, and
// their difference (the change of the patch's disparity), which is free of it. Together they contain all the
// information of both under this error model (generalised least squares). Light has no effect on the
// difference: it determines depth and rotation on skin with moving shading.

#include <array>

#include "patch_model.h"

namespace facenav::head_tracking {

/// Change of a patch between the key frame and now.
struct PatchChange {
  std::array<Eigen::Matrix2d, 2> key_from_now;  // for small displacements, pixels of the level
  std::array<Eigen::Vector3d, 2> ray;           // from each camera to the patch now, Head
  double light_change = 0.0;                    // over the face, see shadingSigma()
};

/// Two equations for xi: combine * (left, right displacement) = jacobian * xi, with errors of this
/// covariance.
struct PatchObservation {
  Eigen::Matrix<double, 2, 4> combine = Eigen::Matrix<double, 2, 4>::Zero();
  Eigen::Matrix<double, 2, 6> jacobian;
  Eigen::Matrix2d covariance;
};

/// The observation by camera `c` alone.
PatchObservation observedByOne(const Patch& patch, int c, const PatchChange& change);
/// The observations by both cameras: mean and difference; independent, in pixels of the left key image. Not
/// for a patch that one camera sees edge-on (canBePaired() is false).
bool canBePaired(const Patch& patch);
std::array<PatchObservation, 2> observedByBoth(const Patch& patch, const PatchChange& change);

}  // namespace facenav::head_tracking
