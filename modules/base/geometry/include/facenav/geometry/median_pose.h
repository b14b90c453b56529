#pragma once
// The middle of several poses that outliers cannot move far: the point with the least sum of distances to all
// (geometric median), and the rotation with the least sum of angles (Hartley, Aftab and Trumpf 2011), both by
// Weiszfeld steps.

#include <Eigen/Core>
#include <vector>

namespace facenav {
inline namespace geometry {

/// Geometric median of `points` (at least one), in their unit.
Eigen::Vector3d medianPoint(const std::vector<Eigen::Vector3d>& points);
/// Median of `rotations` (at least one, each less than 90 degrees from their mean).
Eigen::Matrix3d medianRotation(const std::vector<Eigen::Matrix3d>& rotations);

}  // namespace geometry
}  // namespace facenav
