#include "facenav/health/camera_drift.h"

#include <algorithm>
#include <cmath>

#include "facenav/anatomy/head_norms.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"
#include "facenav/health/rig_monitor.h"
#include "relative_pose.h"
#include "rig_words.h"

namespace facenav::health {
namespace {

// Possible motion of a camera between the reference and the first frame.
constexpr double kPriorTurn_rad = 0.2 * kRadPerDeg, kPriorShift_mm = 1.0;
// Random walk of a slipping mount in one second. kFollowing: factor for a camera that is known to move; a
// smaller one lets the correction lag behind.
constexpr double kWalkTurn_rad = 0.02 * kRadPerDeg, kWalkShift_mm = 0.2, kFollowing = 5.0;
constexpr double kLongestUnseen_s = 2.0;
// Errors of the face (light, expression) last for some frames: a frame counts as half a measurement, and the
// estimate is never more certain than one frame.
constexpr double kLasting = 2.0;
// Squared sigmas between a frame and the estimate: a wrong fit, or a camera that was knocked. No pose is
// shown. kFramesInARow of them are a knock.
constexpr double kContradiction = 36.0;
constexpr double kSmoothed_s = 0.03;  // time constant of the correction
constexpr double kSure_mm = 0.8;  // tolerated error of the pose at the cortex; three of them make it wrong
constexpr double kMostUnsure_rad = 0.05 * kRadPerDeg;
constexpr double kMostTurn_rad = 0.6 * kRadPerDeg, kMostShift_mm = 4.0;  // beyond this, a mount is broken

Matrix6d squares(double turn_rad, double shift_mm) {
  Vector6d each;
  each << Eigen::Vector3d::Constant(turn_rad * turn_rad), Eigen::Vector3d::Constant(shift_mm * shift_mm);
  return each.asDiagonal();
}

}  // namespace

void CameraDrift::predict(double since_s) {
  const double faster = has_moved_ ? kFollowing : 1.0;
  covariance_ += since_s * squares(faster * kWalkTurn_rad, faster * kWalkShift_mm);
  const Matrix6d most = squares(kPriorTurn_rad, kPriorShift_mm);
  for (int i = 0; i < 6; ++i) {  // no axis gets less certain than before the first frame
    if (covariance_(i, i) <= most(i, i)) continue;
    const double shrink = std::sqrt(most(i, i) / covariance_(i, i));
    covariance_.row(i) *= shrink, covariance_.col(i) *= shrink;
  }
}

void CameraDrift::update(const Vector6d& seen, const Matrix6d& frame, const Matrix6d& key) {
  const Vector6d innovation = seen - moved_;
  const auto isContradicted = [&] {
    const Matrix6d expected = covariance_ + kLasting * frame + key;
    return !(innovation.dot(inverseOf(expected) * innovation) < kContradiction);
  };
  contradicted_ = isContradicted() ? contradicted_ + 1 : 0;
  if (contradicted_ >= kFramesInARow) covariance_ = squares(kMostTurn_rad, kMostShift_mm);
  if (contradicted_ > 0 && isContradicted()) return;
  contradicted_ = 0;
  const Matrix6d error = kLasting * frame, gain = covariance_ * inverseOf(Matrix6d(covariance_ + error));
  moved_ += gain * innovation;
  const Matrix6d rest = Matrix6d::Identity() - gain;
  covariance_ = rest * covariance_ * rest.transpose() + gain * error * gain.transpose();
  certainty_ = covariance_ + frame + key;
}

void CameraDrift::add(const RigObservation& frame) {
  if (!frame.right_camera) return;
  const RightPoseObservation& seen = *frame.right_camera;
  const Timestamp captured = frame.captured;
  if (!last_) covariance_ = squares(kPriorTurn_rad, kPriorShift_mm);
  const double since_s = last_ ? std::abs(captured - *last_) : 0.0;
  predict(since_s);
  last_ = captured, is_unseen_ = false;
  if (seen.newest_key > 0) keys_.try_emplace(seen.newest_key, KeyFrame{moved_ - corrected_, certainty_});
  const KeyFrame key = seen.key > 0 ? keys_[seen.key] : KeyFrame{};
  update(seen.moved + corrected_ + key.left_over, seen.covariance, key.covariance);
  judge(seen, frame.face_centre, since_s);
}

void CameraDrift::addWithoutFace(Timestamp captured) {
  contradicted_ = 0;
  is_unseen_ = has_moved_ && last_ && std::abs(captured - *last_) > kLongestUnseen_s;
}

void CameraDrift::judge(const RightPoseObservation& seen, const Point<Camera>& face_centre, double since_s) {
  const Vector6d left_over = moved_ - corrected_;
  statistic_ = left_over.dot(inverseOf(certainty_) * left_over);
  Eigen::Matrix<double, 3, 6> carry;
  carry << -skew(anatomy::kFaceToCortex_mm * face_centre.mm.normalized()), Eigen::Matrix3d::Identity();
  carry = (carry * seen.pose_by_moved).eval();
  effect_mm_ = (carry * left_over).norm();
  effect_sigma_mm_ = std::sqrt((carry * certainty_ * carry.transpose()).trace());
  if (statistic_ > kMovedStatistic || effect_mm_ > kSignificant * effect_sigma_mm_) has_moved_ = true;
  // Corrects at once when the motion is first noticed, later smoothed.
  if (has_moved_ && !fault())
    corrected_ += (is_followed_ ? 1.0 - std::exp(-since_s / kSmoothed_s) : 1.0) * (moved_ - corrected_);
  is_followed_ = has_moved_ && !fault();
}

RigidTransform<RightCamera, Camera> CameraDrift::right_T_left() const {
  return RigidTransform<RightCamera, Camera>::fromIsometry(expRigid(corrected_) * calibrated_.isometry());
}

double CameraDrift::turnSigma_rad() const {
  if (!has_moved_) return 0.0;
  const double certain_rad = std::sqrt(certainty_.diagonal().head<3>().maxCoeff());
  return std::min(kMostUnsure_rad, std::hypot(certain_rad, (moved_ - corrected_).head<3>().norm()));
}

std::optional<RigVerdict> CameraDrift::fault() const {
  if (!has_moved_ && contradicted_ == 0) return std::nullopt;
  const bool is_far = moved_.head<3>().norm() > kMostTurn_rad || moved_.tail<3>().norm() > kMostShift_mm;
  if (!is_far && !is_unseen_ && contradicted_ == 0 && effect_sigma_mm_ < kSure_mm) return std::nullopt;
  return movedOnMount(kDegPerRad * moved_.head<3>().norm());
}

std::optional<CorrectedMotion> CameraDrift::correction() const {
  if (!has_moved_) return std::nullopt;
  return CorrectedMotion{kDegPerRad * moved_.head<3>().norm()};
}

}  // namespace facenav::health
