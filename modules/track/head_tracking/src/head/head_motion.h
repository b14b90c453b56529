#pragma once
// HeadMotion: last pose and velocity of the tracked head. A constant-velocity model predicts the pose in the
// next frame. Velocities are (w rad/s, v mm/s), Head's axes, about the model's centre.

#include <Eigen/Geometry>

#include "facenav/core/timestamp.h"
#include "facenav/geometry/rotation.h"

namespace facenav::head_tracking {

/// Upper bound of a person's walking speed.
inline constexpr double kWalk_mm_s = 1500.0;

/// Time over which a velocity predicts a pose, and a face that was seen is still the same person's.
inline constexpr double kMoment_s = 0.3;

class HeadMotion {
 public:
  HeadMotion() = default;
  explicit HeadMotion(const Eigen::Vector3d& centre_mm) : centre_mm_(centre_mm) {}

  bool isKnown() const { return is_known_; }
  void forget() { *this = HeadMotion(centre_mm_); }
  /// Last camera_T_head.
  const Eigen::Isometry3d& pose() const { return pose_; }
  Timestamp captured() const { return captured_; }
  /// Velocity from one frame to the next.
  const Vector6d& velocity() const { return velocity_; }
  /// Velocity smoothed over some frames: that of one frame has the errors of two poses.
  const Vector6d& steady() const { return steady_; }
  /// Upper bound of the speed of a point `depth_mm` behind the face, from the steady velocity.
  double speedBehind_mm_s(double depth_mm) const {
    return steady_.tail<3>().norm() + depth_mm * steady_.head<3>().norm();
  }

  bool isRecent(Timestamp now) const;
  Eigen::Isometry3d predicted(Timestamp now) const;
  /// The steady velocity if the head is at `pose` in the present frame.
  Vector6d steadyWith(const Eigen::Isometry3d& pose, Timestamp captured) const;
  /// Adds a tracked pose.
  void add(const Eigen::Isometry3d& pose, Timestamp captured);
  /// Sets the prediction to no motion, because the head is lost.
  void stop() { velocity_.setZero(), steady_.setZero(); }
  void stopSteady() { steady_.setZero(); }

 private:
  Vector6d velocityTo(const Eigen::Isometry3d& pose, double since_s) const;
  Vector6d smoothed(const Vector6d& velocity, double since_s) const;

  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();
  bool is_known_ = false;
  Eigen::Isometry3d pose_ = Eigen::Isometry3d::Identity();
  Vector6d velocity_ = Vector6d::Zero(), steady_ = Vector6d::Zero();
  Timestamp captured_;
};

}  // namespace facenav::head_tracking
