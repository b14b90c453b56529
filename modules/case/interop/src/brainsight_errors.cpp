#include "facenav/interop/brainsight_errors.h"

#include <algorithm>
#include <cmath>

#include "facenav/geometry/rotation.h"
#include "facenav/interop/axes.h"

namespace facenav::interop {

BrainsightErrors brainsightErrors(const RigidTransform<Mri, Coil>& sample,
                                  const RigidTransform<Mri, Coil>& target) {
  const Eigen::Matrix3d s = sample.rotation() * axesOf(CoilAxes::brainsight);
  const Eigen::Matrix3d t = target.rotation() * axesOf(CoilAxes::brainsight);
  const Eigen::Vector3d between = target.translation_mm() - sample.translation_mm();
  const Eigen::Vector3d z = s.col(2);
  const Eigen::Vector3d y_target = t.col(1) - t.col(1).dot(z) * z;  // in the plane across the sample's axis
  BrainsightErrors errors;
  errors.distance_mm = between.norm();
  errors.target_mm = between.cross(z).norm();
  errors.angular_deg = std::atan2(t.col(2).cross(z).norm(), t.col(2).dot(z)) * kDegPerRad;
  errors.twist_deg = std::atan2(y_target.cross(s.col(1)).dot(z), y_target.dot(s.col(1))) * kDegPerRad;
  return errors;
}

}  // namespace facenav::interop
