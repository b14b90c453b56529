#pragma once
// What the displacements of one patch tell about the pose. Its errors are of two kinds. Light that stays with
// the lamps while the skin turns beneath it, and errors of shape, displace the patch in both images alike (in
// the room, three to five times as much as all the rest); noise and sampling are each image's own. So the
// two displacements are taken apart into their mean, which shares the common error, and their difference,
// the change of the patch's disparity, which is free of it: together they tell exactly what both tell under
// this error model (generalised least squares). The difference is what light cannot forge: it holds depth and
// turn on skin whose shading creeps.

#include <array>

#include "patch_model.h"

namespace facenav::head_tracking {

/// A patch as it is placed now, beside the key frame.
struct PatchChange {
  std::array<Eigen::Matrix2d, 2> key_from_now;  // of small displacements, pixels of the level
  std::array<Eigen::Vector3d, 2> ray;           // from each camera to the patch now, Head
  double light_change = 0.0;                    // over the face, see shadingSigma()
};

/// Two equations on xi: combine * (left, right displacement) = jacobian * xi, with errors of this covariance.
struct PatchTelling {
  Eigen::Matrix<double, 2, 4> combine = Eigen::Matrix<double, 2, 4>::Zero();
  Eigen::Matrix<double, 2, 6> jacobian;
  Eigen::Matrix2d covariance;
};

/// What camera `c` alone tells.
PatchTelling toldByOne(const Patch& patch, int c, const PatchChange& change);
/// What both tell: mean, difference; independent of each other, in pixels of the left key image. Not for a
/// patch that one camera sees edge-on (false).
bool canBePaired(const Patch& patch);
std::array<PatchTelling, 2> toldByBoth(const Patch& patch, const PatchChange& change);

}  // namespace facenav::head_tracking
