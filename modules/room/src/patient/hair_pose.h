#pragma once
// HairPose: how the hair lies at one moment, against the skull. Roots stay; what is longer moves more.

#include <Eigen/Core>
#include <cstdint>

namespace facenav::room {

struct HairPose {
  double sway_mm = 0.0;  // how far hair may move; 0: no hair is loose, and no locks are drawn
  Eigen::Vector3d lean_mm = Eigen::Vector3d::Zero();  // Mri: all of it lags behind the head's turn
  std::uint64_t pattern = 0;                          // which way each tuft lies; 0: as combed

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
