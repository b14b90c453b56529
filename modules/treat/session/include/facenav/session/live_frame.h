#pragma once
// Makes what outputs send (links/live_output.h) from a state of the session. Names and frames are those of
// resources/doc/live.md: the tracker is the left camera, the subject is the head.

#include "facenav/links/live_output.h"
#include "facenav/session/navigation_state.h"

namespace facenav::session {

/// Poses SubjectToTracker and Coil1ToTracker; with an alignment also SubjectToMri, CoilToMri and CoilToTarget
/// (lost without a target). Those of a second coil are Coil2ToTracker, Coil2ToMri and Coil2ToTarget. The time
/// is that of the frame's capture, or of its playback.
links::LiveFrame liveFrameOf(const NavigationState& state);

}  // namespace facenav::session
