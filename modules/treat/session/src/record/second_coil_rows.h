#pragma once
// Lines of a session's tables for the second coil.

#include "facenav/casefile/session_log.h"
#include "facenav/session/navigation_state.h"

namespace facenav::session {

/// Adds the second coil's lines of a state; nothing without one. No guidance is given in a pause.
void logSecondCoil(const NavigationState& state, bool is_paused, casefile::SessionLog& log);

}  // namespace facenav::session
