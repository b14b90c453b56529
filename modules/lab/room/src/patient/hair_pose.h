#pragma once
// HairPose: the position of the hair at one moment, relative to the skull. Roots do not move; longer hair
// moves more.

#include <Eigen/Core>
#include <cstdint>

namespace facenav::room {

struct HairPose {
  double sway_mm = 0.0;  // largest shift of hair; 0: no loose hair, and no locks are drawn
  Eigen::Vector3d lean_mm = Eigen::Vector3d::Zero();  // Mri: common shift, behind the head's turn
  std::uint64_t pattern = 0;                          // seed of the tufts' directions; 0: as combed

  bool isAtRest() const { return sway_mm <= 0.0 || (pattern == 0 && lean_mm.isZero()); }
  bool operator==(const HairPose& other) const {
    return sway_mm == other.sway_mm && lean_mm == other.lean_mm && pattern == other.pattern;
  }
};

/// Shift (Mri, mm) of hair that grows at a point of the skin with its outward unit normal: along the skin, at
/// most `sway_mm`.
Eigen::Vector3d hairShift_mm(const HairPose& pose, const Eigen::Vector3d& p_mm,
                             const Eigen::Vector3d& normal);

}  // namespace facenav::room
