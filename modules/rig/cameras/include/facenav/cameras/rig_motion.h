#pragma once
// The rig after a motion of its right camera.

#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/rotation.h"

namespace facenav::cameras {

/// Moves the right camera by `motion`: increment of right_T_left (rotation rad, translation mm; applied on
/// the left).
inline StereoRig turned(const StereoRig& rig, const Vector6d& motion) {
  StereoRig moved = rig;
  Eigen::Isometry3d pose = rig.right_T_left.isometry();
  pose.linear() = expRotation(motion.head<3>()) * pose.linear();
  pose.translation() = expRotation(motion.head<3>()) * pose.translation() + motion.tail<3>();
  moved.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(pose);
  return moved;
}

}  // namespace facenav::cameras
