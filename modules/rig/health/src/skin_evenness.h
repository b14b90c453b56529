#pragma once
// Tests whether one pose of the right camera explains the matches all over the face. In images of one moment
// only the errors of the matches remain. Between two moments skin moves over the skull (cheeks, lips,
// nostrils), and neighbouring matches leave their epipolar lines together.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "relative_pose.h"

namespace facenav::health {

/// Root mean square over the matches of the residual common to the neighbours within 25 px: the median of
/// their signed distances from the epipolar lines, in sigmas of RayPair, limited to `most` sigmas. `left_px`:
/// pixel of each of `rays`.
double sharedResidual(const Eigen::Isometry3d& right_T_left, const std::vector<RayPair>& rays,
                      const std::vector<Eigen::Vector2d>& left_px, double most);

}  // namespace facenav::health
