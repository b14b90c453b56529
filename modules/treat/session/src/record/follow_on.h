#pragma once
// Numbers and times of the frames of a continued session. Private to session.

#include <cstdint>

#include "facenav/casefile/session_so_far.h"
#include "facenav/session/navigation_state.h"

namespace facenav::session {

/// Offsets added to the numbers and times of the frames, so that they continue those of the session's files.
struct FollowOn {
  std::int64_t frames = 0;
  double seconds = 0;
};

/// Computes the offsets. Live cameras' clock may have continued; frame numbers restart, and so does a
/// recording's clock.
FollowOn followOn(const casefile::SessionSoFar& so_far, const NavigationState& first);

}  // namespace facenav::session
