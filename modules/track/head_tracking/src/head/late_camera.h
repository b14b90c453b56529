#pragma once
// LateCamera: the rig for a moving head when the right camera exposes later than the left one. The right
// camera sees the head at its own exposure, which is equivalent to another pose of that camera. The delay is
// learnt from the moving head (offset_filter.h).

#include <cmath>

#include "facenav/cameras/stereo_rig.h"
#include "head_motion.h"
#include "key_frames.h"
#include "offset_filter.h"

namespace facenav::head_tracking {

class LateCamera {
 public:
  LateCamera() = default;
  LateCamera(const cameras::StereoRig& rig, const Eigen::Vector3d& centre_mm)
      : rig_(rig), now_(rig), centre_mm_(centre_mm) {}

  /// Sets a new pose of the right camera, which has moved on its mount.
  void moveRight(const RigidTransform<RightCamera, Camera>& right_T_left) {
    rig_.right_T_left = right_T_left;
  }
  /// Sets the delay of this frame by the drivers' time stamps, s.
  void state(double late_s) { offset_.state(late_s); }
  /// The rig for a head at rest.
  const cameras::StereoRig& rig() const { return rig_; }
  /// The rig for the next fit, set by allowFor().
  const cameras::StereoRig& now() const { return now_; }
  double late_s() const { return offset_.late_s(); }
  double sigma_s() const { return offset_.sigma_s(); }
  /// Upper bound of the delay (two sigmas).
  double mostLate_s() const { return std::abs(late_s()) + 2.0 * sigma_s(); }

  /// Call before a fit with `key` near `pose` of a head with velocity `steady` (HeadMotion). Corrects for the
  /// head's motion relative to that in the key frame's images.
  void allowFor(const KeyFrame& key, const Eigen::Isometry3d& pose, const Vector6d& steady);
  /// Call after a tracked frame: learns the delay and adds its uncertainty to the verdict's covariance.
  Verdict learn(const KeyFrame& key, const PoseFit& fit, const HeadMotion& before, Timestamp captured,
                Verdict verdict);
  /// Motion of a head with this velocity from one exposure to the other.
  KeyMotion motionOf(const Vector6d& velocity) const { return {velocity, late_s() * velocity}; }
  /// The rig for a head at `pose` with this motion.
  cameras::StereoRig rigFor(const Eigen::Isometry3d& pose, const KeyMotion& moving) const;

 private:
  RigidTransform<RightCamera, Camera> rightThatSees(const Eigen::Isometry3d& pose,
                                                    const Vector6d& later) const;

  cameras::StereoRig rig_, now_;
  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();
  OffsetFilter offset_;
  Vector6d allowed_ =
      Vector6d::Zero();  // correction for the motion between the exposures, beyond the key frame's
};

}  // namespace facenav::head_tracking
