#include "hair_pose.h"

#include <algorithm>

#include "optics/noise_field.h"

namespace facenav::room {
namespace {

constexpr double kTuft_mm = 12.0;   // tufts of about twice this size move together
constexpr double kTuftShare = 0.7;  // standard deviation of a tuft's shift, relative to the largest

Eigen::Vector3d tuft(const Eigen::Vector3d& p_mm, std::uint64_t pattern) {
  if (pattern == 0) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d q = p_mm + Eigen::Vector3d(31.0, 57.0, 83.0) * double(pattern % 977);
  return {sharedNoise().at(q, kTuft_mm), sharedNoise().at(q + 300.0 * Eigen::Vector3d::UnitX(), kTuft_mm),
          sharedNoise().at(q + 300.0 * Eigen::Vector3d::UnitY(), kTuft_mm)};
}

}  // namespace

Eigen::Vector3d hairShift_mm(const HairPose& pose, const Eigen::Vector3d& p_mm,
                             const Eigen::Vector3d& normal) {
  if (pose.isAtRest()) return Eigen::Vector3d::Zero();
  Eigen::Vector3d shift = pose.lean_mm + kTuftShare * pose.sway_mm * tuft(p_mm, pose.pattern);
  shift -= shift.dot(normal) * normal;
  return shift * std::min(1.0, pose.sway_mm / std::max(1e-9, shift.norm()));
}

}  // namespace facenav::room
