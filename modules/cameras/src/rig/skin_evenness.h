#pragma once
// Whether one pose of the right camera explains matches all over the face. Pictures of one moment leave the
// errors of the matches alone. Between two moments skin moves over the skull (cheeks, lips, nostrils), and
// matches near each other leave the epipolar lines together.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "relative_pose.h"

namespace facenav::cameras {

/// Root mean square over the matches of what each and its neighbours within 25 px share: the median of their
/// signed distances from the epipolar lines, sigmas of RayPair, counted as `most` sigmas at most. `left_px`:
/// of each of `rays`.
double sharedResidual(const Eigen::Isometry3d& right_T_left, const std::vector<RayPair>& rays,
                      const std::vector<Eigen::Vector2d>& left_px, double most);

}  // namespace facenav::cameras
