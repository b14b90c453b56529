#include "late_camera.h"

namespace facenav::head_tracking {

RigidTransform<RightCamera, Camera> LateCamera::rightThatSees(const Eigen::Isometry3d& pose,
                                                              const Vector6d& later) const {
  const Eigen::Isometry3d moved = pose * Eigen::Translation3d(centre_mm_) * expRigid(later) *
                                  Eigen::Translation3d(-centre_mm_) * pose.inverse();
  return RigidTransform<RightCamera, Camera>::fromIsometry(rig_.right_T_left.isometry() * moved);
}

void LateCamera::allowFor(const KeyFrame& key, const Eigen::Isometry3d& pose, const Vector6d& steady) {
  allowed_ = offset_.late_s() * (steady - key.moving.velocity);
  now_.right_T_left = rightThatSees(pose, allowed_ + key.moving.allowed);
}

Verdict LateCamera::learn(const KeyFrame& key, const PoseFit& fit, const HeadMotion& before,
                          Timestamp captured, Verdict verdict) {
  const double since_s = captured - before.captured();
  if (since_s < 1e-4) return verdict;
  offset_.add(key.level[0], fit, before.steadyWith(fit.motion, captured) - key.moving.velocity, allowed_,
              since_s);
  Matrix6d rotate = Matrix6d::Zero();  // from Head's axes to Camera's
  rotate.topLeftCorner<3, 3>() = rotate.bottomRightCorner<3, 3>() = fit.motion.linear();
  verdict.covariance += rotate * offset_.poseCovariance() * rotate.transpose();
  return verdict;
}

cameras::StereoRig LateCamera::rigFor(const Eigen::Isometry3d& pose, const KeyMotion& moving) const {
  cameras::StereoRig rig = rig_;
  rig.right_T_left = rightThatSees(pose, moving.allowed);
  return rig;
}

}  // namespace facenav::head_tracking
