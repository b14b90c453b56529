#pragma once
// TimeKeeper: adds up how long a running session was paused and guided, by the steady clock, and keeps it in
// the session's times.json (casefile/session_times.h). Used by the log's writing thread. Private to session.

#include <filesystem>
#include <optional>

#include "facenav/casefile/session_times.h"
#include "facenav/session/navigation_state.h"

namespace facenav::session {

class TimeKeeper {
 public:
  /// `idle_s`: since the last run of a continued session; nothing: a new session.
  TimeKeeper(const std::filesystem::path& session_folder, std::optional<double> idle_s);

  /// Adds a frame. Call it for each state, in order.
  void follow(const NavigationState& state, bool is_paused);
  /// Writes the file, if the last time is some seconds ago or `is_last`. Throws Error.
  void keep(double running_s, double paused_s, bool is_last);

 private:
  const std::filesystem::path folder_;
  casefile::SessionTimes earlier_, now_;
  std::optional<Timestamp> last_, kept_;
  std::optional<guidance::State> last_state_;  // nothing: not guided
};

}  // namespace facenav::session
