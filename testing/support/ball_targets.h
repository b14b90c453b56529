#pragma once
// A target on the ball case (ball_case.h).

#include <string>

#include "facenav/guidance/target.h"

namespace facenav::testing {

/// Makes a target over the top of the ball's brain: the coil's centre lies 2 mm above the skin.
inline guidance::Target targetOnTop(const std::string& name) {
  guidance::Target target;
  target.name = name;
  target.mri_T_target = RigidTransform<Mri, frames::Target>(Eigen::Quaterniond(0, 1, 0, 0), {0, 0, 92});
  target.scalp_point = Point<Mri>(0, 0, 90);
  target.cortex_point = Point<Mri>(0, 0, 40);
  return target;
}

}  // namespace facenav::testing
