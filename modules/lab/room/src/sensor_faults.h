#pragma once
// Faults of ordinary cameras over a recording: automatic exposure, focus, clocks, lost and repeated pairs.
// They follow from the options, the seed and the frame's number.

#include <cstdint>

#include "facenav/room/scenario.h"

namespace facenav::room {

/// Light that the cameras take in this frame, relative to the first.
double lightTaken(const ScenarioOptions& options, double frame);
/// Blur by lost focus (standard deviation, px), of a recording with so many frames.
double defocus_px(const ScenarioOptions& options, double frame, int frames);
/// Delay of the right camera's exposure after the left one's, s.
double rightLate_s(const ScenarioOptions& options, double frame);
/// Returns true if the pair does not arrive. Never the first one.
bool isDropped(const ScenarioOptions& options, std::int64_t frame);
/// Returns true if the previous pair arrives again in its place. Never the first one.
bool isDoubled(const ScenarioOptions& options, std::int64_t frame);

}  // namespace facenav::room
