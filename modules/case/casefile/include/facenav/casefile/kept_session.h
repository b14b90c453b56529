#pragma once
// Reads the stored sessions of a case (sessions/<UTC time>/): events, pulses, and how long guidance was on
// target. Reads session files of all versions; values that a file lacks are absent.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/session_pulses.h"
#include "facenav/casefile/session_times.h"

namespace facenav::casefile {

struct SessionEvent {
  std::string utc, event, detail;
};

struct KeptSession {
  std::filesystem::path folder;
  std::string name;  // the folder's name: its start in UTC
  std::vector<SessionEvent> events;
  SessionPulses pulses;
  /// How long it ran, s, with pauses: from times.json. Older sessions: from the first to the last frame.
  std::optional<double> duration_s;
  std::optional<GuidedTime> guided;             // absent without a target
  std::optional<double> paused_s, away_s = {};  // SessionTimes; absent in older sessions
  /// Time when the session was imported as a file from home (it has no poses.csv then); nothing if it was
  /// made here.
  std::optional<std::string> returned_utc = {};
};

/// Marks, in a session's folder, a session imported as a file from home.
inline constexpr const char* kReturnedFile = "returned.json";

/// Lists the folders in CASE/sessions, oldest first; empty if there are none.
std::vector<std::filesystem::path> sessionFolders(const std::filesystem::path& case_folder);
/// Finds the session with this name, or the only one whose name begins with it; empty: the newest. Throws
/// Error naming the existing sessions if there is none.
std::filesystem::path findSession(const std::filesystem::path& case_folder, const std::string& name);
/// Adds a note to a session that has ended (pain afterwards, an adverse event), as one more event in
/// notes.jsonl beside events.jsonl. Synced when it returns. Throws Error.
void addNote(const std::filesystem::path& session_folder, const std::string& event,
             const std::string& detail);
/// Reads the session's own events, in the order of the file; damaged lines are left out.
std::vector<SessionEvent> readSessionEvents(const std::filesystem::path& session_folder);
/// Reads a session; events and notes are merged by time. Damaged lines are left out and named in
/// pulses.problems. Throws Error where a file cannot be read at all.
KeptSession readSession(const std::filesystem::path& session_folder);

}  // namespace facenav::casefile
