#pragma once
// Habits: what a living patient does in any scenario: blinks, and hair that does not stay as it was.

#include "script.h"

namespace facenav::room {

/// How far the upper lids are down at a time, 0..1: for 0.1-0.3 s every 2-6 s, as the seed says.
double lidsDown(std::uint64_t seed, double time_s);

/// How the hair lies. It lags behind the turn from `seat` to `now`; `visit`: number of the time the patient
/// has sat down, the hair lies otherwise after each.
HairPose looseHair(double sway_mm, const RigidTransform<Room, Mri>& seat,
                   const RigidTransform<Room, Mri>& now, std::uint64_t seed, int visit);

}  // namespace facenav::room
