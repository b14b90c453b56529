#pragma once
// LateCamera: the rig as it sees a moving head whose right picture is exposed later than the left one. The
// right camera sees the head where it is when that camera exposes: as if the camera stood elsewhere. The
// delay is learnt from the moving head (offset_filter.h).

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

  /// The rig that sees a head at rest.
  const cameras::StereoRig& rig() const { return rig_; }
  /// The rig for the fit that follows, as allowFor() set it.
  const cameras::StereoRig& now() const { return now_; }
  double late_s() const { return offset_.late_s(); }
  double sigma_s() const { return offset_.sigma_s(); }
  /// What the delay is hardly more than.
  double mostLate_s() const { return std::abs(late_s()) + 2.0 * sigma_s(); }

  /// Before a fit by `key` near `pose`, of a head that moves with `steady` (HeadMotion): what the head does
  /// beyond what it did when the key frame's pictures were taken.
  void allowFor(const KeyFrame& key, const Eigen::Isometry3d& pose, const Vector6d& steady);
  /// After a tracked frame: learns the delay; what is left uncertain is added to the verdict's covariance.
  Verdict learn(const KeyFrame& key, const PoseFit& fit, const HeadMotion& before, Timestamp captured,
                Verdict verdict);
  /// How a head with this velocity moves from one exposure to the other.
  KeyMotion motionOf(const Vector6d& velocity) const { return {velocity, late_s() * velocity}; }
  /// The rig as it sees a head at `pose` that moves so.
  cameras::StereoRig rigFor(const Eigen::Isometry3d& pose, const KeyMotion& moving) const;

 private:
  RigidTransform<RightCamera, Camera> rightThatSees(const Eigen::Isometry3d& pose,
                                                    const Vector6d& later) const;

  cameras::StereoRig rig_, now_;
  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();
  OffsetFilter offset_;
  Vector6d allowed_ = Vector6d::Zero();  // of the head's motion between the exposures, beyond the key frame's
};

}  // namespace facenav::head_tracking
