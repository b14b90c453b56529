#pragma once
// What a case keeps of its sessions (sessions/<UTC time>/): events, pulses, and how long guidance was on
// target. Reads session files of all versions; what a file does not hold is absent.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/session_pulses.h"

namespace facenav::casefile {

struct SessionEvent {
  std::string utc, event, detail;
};

/// Time by the state of guidance, of guidance.csv. A gap of more than 0.25 s between frames counts as lost:
/// nothing was known then.
struct GuidedTime {
  double on_target_s = 0, adjust_s = 0, lost_s = 0;
  double total_s() const { return on_target_s + adjust_s + lost_s; }
};

struct KeptSession {
  std::filesystem::path folder;
  std::string name;  // the folder's: its start in UTC
  std::vector<SessionEvent> events;
  SessionPulses pulses;
  std::optional<double> duration_s;  // from the first to the last frame of poses.csv
  std::optional<GuidedTime> guided;  // absent without a target
  /// When it came back from home as a file (it has no poses.csv then); nothing: it was made here.
  std::optional<std::string> returned_utc = {};
};

/// In the folder of a session that came back from home as a file.
inline constexpr const char* kReturnedFile = "returned.json";

/// The folders in CASE/sessions, oldest first; empty if there are none.
std::vector<std::filesystem::path> sessionFolders(const std::filesystem::path& case_folder);
/// The session of that name, or of the only one that starts with it; empty: the newest. Throws Error if there
/// is none, naming those that exist.
std::filesystem::path findSession(const std::filesystem::path& case_folder, const std::string& name);
/// Notes something about a session that has ended (pain afterwards, an adverse event): one more event, in
/// notes.jsonl beside events.jsonl. Synced when it returns. Throws Error.
void addNote(const std::filesystem::path& session_folder, const std::string& event,
             const std::string& detail);
/// The session's own events, in the order of the file; damaged lines are left out.
std::vector<SessionEvent> readSessionEvents(const std::filesystem::path& session_folder);
/// Events and notes by their time. Damaged lines are left out and named in pulses.problems. Throws Error
/// where a file cannot be read at all.
KeptSession readSession(const std::filesystem::path& session_folder);

}  // namespace facenav::casefile
