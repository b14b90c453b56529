#pragma once
// Words for a direction on the head, so that a person can tell which way a handle points.

#include <Eigen/Core>
#include <string>

namespace facenav::interop {

/// Where a direction in Mri points: "to the back and right of the head, downwards".
std::string directionInWords(const Eigen::Vector3d& direction);
/// Question about a handle of which the sign is doubtful. `y`: the pose's y axis as written, in Mri.
std::string handleQuestion(const Eigen::Vector3d& y);

}  // namespace facenav::interop
