#pragma once
// What goes wrong in ordinary cameras over a recording: automatic exposure, focus, clocks, lost and repeated
// pairs. All of it follows from the options, the seed and the frame's number.

#include <cstdint>

#include "facenav/room/scenario.h"

namespace facenav::room {

/// Light that the cameras take in this frame, relative to the first.
double lightTaken(const ScenarioOptions& options, double frame);
/// Blur by lost focus (standard deviation, px), of a recording with so many frames.
double defocus_px(const ScenarioOptions& options, double frame, int frames);
/// By how much the right camera exposes after the left one, s.
double rightLate_s(const ScenarioOptions& options, double frame);
/// The pair does not arrive. Never the first one.
bool isDropped(const ScenarioOptions& options, std::int64_t frame);
/// The pair before arrives again in its place. Never the first one.
bool isDoubled(const ScenarioOptions& options, std::int64_t frame);

}  // namespace facenav::room
