#pragma once
// HeadMotion: the last pose of the tracked head with its velocity: a constant-velocity model that predicts
// the next frame's pose. Velocities are (w rad/s, v mm/s), Head's axes, about the model's centre.

#include <Eigen/Geometry>

#include "facenav/core/timestamp.h"
#include "facenav/geometry/rotation.h"

namespace facenav::head_tracking {

/// A person walks no faster.
inline constexpr double kWalk_mm_s = 1500.0;

class HeadMotion {
 public:
  HeadMotion() = default;
  explicit HeadMotion(const Eigen::Vector3d& centre_mm) : centre_mm_(centre_mm) {}

  bool isKnown() const { return is_known_; }
  void forget() { *this = HeadMotion(centre_mm_); }
  /// camera_T_head where the head was seen last.
  const Eigen::Isometry3d& pose() const { return pose_; }
  Timestamp captured() const { return captured_; }
  /// From one frame to the next.
  const Vector6d& velocity() const { return velocity_; }
  /// The same over some frames: the velocity of one frame carries the errors of two poses.
  const Vector6d& steady() const { return steady_; }
  /// Of a point `depth_mm` behind the face, an upper bound, by the steady velocity.
  double speedBehind_mm_s(double depth_mm) const {
    return steady_.tail<3>().norm() + depth_mm * steady_.head<3>().norm();
  }

  bool isRecent(Timestamp now) const;
  Eigen::Isometry3d predicted(Timestamp now) const;
  /// The steady velocity as a pose in the present frame makes it.
  Vector6d steadyWith(const Eigen::Isometry3d& pose, Timestamp captured) const;
  /// The head is tracked there.
  void add(const Eigen::Isometry3d& pose, Timestamp captured);
  /// The head is lost: it is expected where it was.
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
