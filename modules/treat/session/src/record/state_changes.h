#pragma once
// StateChanges: what changed from one frame of a session to the next, as events of its log: face and coil
// found or lost, another coil, faults, cameras away and back, a correction of the rig, a check of the
// registration. Private to session.

#include <optional>
#include <string>

#include "facenav/casefile/session_log.h"
#include "facenav/session/navigation_state.h"

namespace facenav::session {

class StateChanges {
 public:
  /// Call for each state, in order.
  void note(const NavigationState& state, casefile::SessionLog& log);

 private:
  void noteFault(const NavigationState& state, casefile::SessionLog& log);

  // What held at the previous state.
  bool has_head_ = false, has_coil_ = false, has_faulted_ = false, has_corrected_ = false;
  int check_ = 0;
  std::string coil_;               // whose poses the lines of poses.csv are
  std::optional<Timestamp> away_;  // since when a camera is
};

}  // namespace facenav::session
