#pragma once
// Habits: movements of a living patient in any scenario: blinks and hair movement.

#include "script.h"

namespace facenav::room {

/// Closure of the upper lids at a time, 0..1: closed for 0.1-0.3 s every 2-6 s; the seed sets the times.
double lidsDown(std::uint64_t seed, double time_s);

/// Pose of the hair. It lags behind the turn from `seat` to `now`. `visit`: how often the patient has sat
/// down again; the hair is different after each time.
HairPose looseHair(double sway_mm, const RigidTransform<Room, Mri>& seat,
                   const RigidTransform<Room, Mri>& now, std::uint64_t seed, int visit);

}  // namespace facenav::room
