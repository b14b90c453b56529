#pragma once
// SessionSoFar: state of a session of the case, to continue it after a crash, a power cut or a closed window.
// Reads events, pulses and the last frame only.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace facenav::casefile {

struct SessionSoFar {
  std::filesystem::path folder;
  std::string name;                          // the folder's name: its start in UTC
  int last_pulse = 0;                        // number of the newest pulse
  int on_target = 0, outside = 0, lost = 0;  // pulses by their verdict
  std::string target;                        // the last one chosen; empty: none
  bool has_ended = false;                    // false: it was cut off, or still runs
  bool is_paused = false;                    // a pause had begun and not ended
  bool is_running = false;                   // true if another program writes it now
  std::optional<std::int64_t> last_frame;    // in poses.csv; nothing: no frame yet
  double last_t_s = 0;                       // its time
  double idle_s = 0;                         // since the last write to one of the session's files

  int pulses() const { return on_target + outside + lost; }
};

/// Reads the state. Throws Error if the folder is no session, or cannot be read.
SessionSoFar sessionSoFar(const std::filesystem::path& session_folder);
/// Reads the state of the case's newest session; nothing if there is none.
std::optional<SessionSoFar> newestSession(const std::filesystem::path& case_folder);

}  // namespace facenav::casefile
