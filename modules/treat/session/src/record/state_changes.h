#pragma once
// StateChanges: logs the changes from one frame of a session to the next as events: face and coil found or
// lost, another coil, faults, cameras away and back, a correction of the rig, a check of the registration.
// Private to session.

#include <optional>
#include <string>

#include "facenav/casefile/session_log.h"
#include "facenav/session/navigation_state.h"

namespace facenav::session {

class StateChanges {
 public:
  /// Compares a state with the previous one. Call it for each state, in order.
  void note(const NavigationState& state, casefile::SessionLog& log);

 private:
  void noteSecond(const NavigationState& state, casefile::SessionLog& log);
  void noteFault(const NavigationState& state, casefile::SessionLog& log);

  // Values of the previous state.
  bool has_head_ = false, has_coil_ = false, has_second_ = false, has_faulted_ = false,
       has_corrected_ = false;
  int check_ = 0;
  std::string coil_, second_;      // coils of the lines of poses.csv and of poses_coil2.csv
  std::optional<Timestamp> away_;  // time since which a camera is away
};

}  // namespace facenav::session
