#pragma once
// SessionTimes: how long a session ran, was paused, and guided with which state. All by the machine's steady
// clock, in sessions/<UTC time>/times.json. The session rewrites it every few seconds while it runs, so a
// crash loses seconds at most. Older sessions lack the file (guided_time.h).

#include <filesystem>
#include <optional>

namespace facenav::casefile {

/// Durations by the state of guidance. Time in a pause, without a target or while the program did not run is
/// in none of them. lost: head or coil had no pose.
struct GuidedTime {
  double on_target_s = 0, adjust_s = 0, lost_s = 0;
  double total_s() const { return on_target_s + adjust_s + lost_s; }
};

struct SessionTimes {
  double running_s = 0;  // with pauses; without the time in which the program did not run
  double paused_s = 0;   // of it
  double away_s = 0;     // the program did not run: from a crash or an end until the session was continued
  GuidedTime guided;
};

/// Writes times.json, 0600. Throws Error.
void writeSessionTimes(const SessionTimes& times, const std::filesystem::path& session_folder);
/// Reads times.json; nothing if there is none or it is damaged.
std::optional<SessionTimes> readSessionTimes(const std::filesystem::path& session_folder);

}  // namespace facenav::casefile
