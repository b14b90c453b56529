#include "head_motion.h"

#include <algorithm>
#include <cmath>

namespace facenav::head_tracking {
namespace {

constexpr double kSteady_s = 0.03;  // time constant of the steady velocity
constexpr double kSameFrame_s = 1e-4;

}  // namespace

bool HeadMotion::isRecent(Timestamp now) const {
  const double since_s = now - captured_;
  return is_known_ && since_s >= 0 && since_s < kMoment_s;
}

Eigen::Isometry3d HeadMotion::predicted(Timestamp now) const {
  return pose_ * Eigen::Translation3d(centre_mm_) * expRigid(velocity_ * (now - captured_)) *
         Eigen::Translation3d(-centre_mm_);
}

Vector6d HeadMotion::steadyWith(const Eigen::Isometry3d& pose, Timestamp captured) const {
  const double since_s = captured - captured_;
  return since_s < kSameFrame_s ? steady_ : smoothed(velocityTo(pose, since_s), since_s);
}

void HeadMotion::add(const Eigen::Isometry3d& pose, Timestamp captured) {
  Vector6d velocity = Vector6d::Zero();
  const double since_s = is_known_ ? captured - captured_ : 0.0;
  if (since_s > kSameFrame_s && since_s < kMoment_s) velocity = velocityTo(pose, since_s);
  steady_ = is_known_ ? smoothed(velocity, since_s) : velocity;
  pose_ = pose, velocity_ = velocity, captured_ = captured, is_known_ = true;
}

Vector6d HeadMotion::velocityTo(const Eigen::Isometry3d& pose, double since_s) const {
  const Eigen::Isometry3d step = pose_.inverse() * pose;
  Vector6d velocity;
  velocity.head<3>() = logRotation(step.linear()) / since_s;
  velocity.tail<3>() = (step * centre_mm_ - centre_mm_) / since_s;
  return velocity;
}

Vector6d HeadMotion::smoothed(const Vector6d& velocity, double since_s) const {
  return steady_ + (1.0 - std::exp(-std::max(0.0, since_s) / kSteady_s)) * (velocity - steady_);
}

}  // namespace facenav::head_tracking
