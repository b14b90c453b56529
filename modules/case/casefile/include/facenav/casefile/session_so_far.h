#pragma once
// SessionSoFar: what a session of the case holds so far, so that it can be gone on with after a crash, a
// power cut or a closed window. Reads events, pulses and the last frame; not the frames before it.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace facenav::casefile {

struct SessionSoFar {
  std::filesystem::path folder;
  std::string name;                          // the folder's: its start in UTC
  int last_pulse = 0;                        // number of the newest pulse
  int on_target = 0, outside = 0, lost = 0;  // pulses by their verdict
  std::string target;                        // the last one chosen; empty: none
  bool has_ended = false;                    // it was ended; false: it was cut off, or still runs
  bool is_paused = false;                    // a pause had begun and not ended
  bool is_running = false;                   // another program writes it now
  std::optional<std::int64_t> last_frame;    // of poses.csv; nothing: no frame yet
  double last_t_s = 0;                       // its time
  double idle_s = 0;                         // since a file of the session was written, by the files' times

  int pulses() const { return on_target + outside + lost; }
};

/// Throws Error if it is no session, or cannot be read.
SessionSoFar sessionSoFar(const std::filesystem::path& session_folder);
/// The case's newest session; nothing if there is none.
std::optional<SessionSoFar> newestSession(const std::filesystem::path& case_folder);

}  // namespace facenav::casefile
