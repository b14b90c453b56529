#include "habits.h"

#include <algorithm>

#include "dice.h"
#include "facenav/geometry/rotation.h"
#include "script_setting.h"

namespace facenav::room {
namespace {

constexpr double kShortestBlink_s = 0.1, kLongestBlink_s = 0.3, kSoonest_s = 2.0, kLatest_s = 6.0;
constexpr double kLag_mm_per_rad = 20.0;  // of the hair behind the head's turn; estimated, not measured

/// Closure during a blink: the lids need 0.3 of it to close and 0.5 to open.
double closing(double share) { return std::min(ease(share / 0.3), ease((1.0 - share) / 0.5)); }

}  // namespace

double lidsDown(std::uint64_t seed, double time_s) {
  Dice dice(seed * 7331 + 11);
  double start_s = dice.between(0.0, kLatest_s - kSoonest_s);
  while (time_s >= start_s) {
    const double lasts_s = dice.between(kShortestBlink_s, kLongestBlink_s);
    if (time_s < start_s + lasts_s) return closing((time_s - start_s) / lasts_s);
    start_s += dice.between(kSoonest_s, kLatest_s);
  }
  return 0.0;
}

HairPose looseHair(double sway_mm, const RigidTransform<Room, Mri>& seat,
                   const RigidTransform<Room, Mri>& now, std::uint64_t seed, int visit) {
  HairPose hair;
  hair.sway_mm = sway_mm;
  if (sway_mm <= 0.0) return hair;
  hair.pattern = visit == 0 ? 0 : 1 + (seed * 59 + std::uint64_t(visit)) % 900;
  const Eigen::Vector3d turn = logRotation(seat.rotation().transpose() * now.rotation());  // Mri
  // The turn moves scalp above the pivot by turn x up and scalp in front of it by turn x anterior; the hair
  // lags behind.
  const Eigen::Vector3d goes = turn.cross(Eigen::Vector3d::UnitZ()) + turn.cross(Eigen::Vector3d::UnitY());
  hair.lean_mm = -kLag_mm_per_rad * goes;
  hair.lean_mm *= std::min(1.0, sway_mm / std::max(1e-9, hair.lean_mm.norm()));
  return hair;
}

}  // namespace facenav::room
