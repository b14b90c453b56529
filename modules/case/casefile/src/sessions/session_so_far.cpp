#include "facenav/casefile/session_so_far.h"

#include <algorithm>
#include <chrono>

#include "appended_file.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/core/error.h"
#include "guided_time.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

void readStory(const std::vector<SessionEvent>& events, SessionSoFar& so_far) {
  for (const auto& [utc, event, detail] : events) {
    if (event == "target") so_far.target = detail;
    if (event == "pause" || event == "resume") so_far.is_paused = event == "pause";
    if (event == "session ended" || event == "session continued") so_far.has_ended = event == "session ended";
  }
}

void countPulses(const fs::path& folder, SessionSoFar& so_far) {
  for (const auto& reviewed : readSessionPulses(folder).pulses) {
    so_far.last_pulse = std::max(so_far.last_pulse, reviewed.pulse.number);
    ++(reviewed.pulse.status == PulseStatus::on_target ? so_far.on_target
       : reviewed.pulse.status == PulseStatus::outside ? so_far.outside
                                                       : so_far.lost);
  }
}

double idleOf(const fs::path& folder) {
  std::optional<fs::file_time_type> newest;
  for (const char* name : {"events.jsonl", "pulses.jsonl", "poses.csv"}) {
    std::error_code missing;
    const auto time = fs::last_write_time(folder / name, missing);
    if (!missing && (!newest || time > *newest)) newest = time;
  }
  if (!newest) return 0;
  const std::chrono::duration<double> idle = fs::file_time_type::clock::now() - *newest;
  return std::max(0.0, idle.count());  // the clock may have been set back
}

}  // namespace

SessionSoFar sessionSoFar(const fs::path& session_folder) {
  if (!fs::exists(session_folder / "events.jsonl"))
    throw Error("this is no session", session_folder.string(), "choose one of the case's sessions");
  SessionSoFar so_far;
  so_far.folder = session_folder;
  so_far.name = session_folder.filename().string();
  so_far.idle_s = idleOf(session_folder);
  so_far.is_running = isLocked(session_folder / "events.jsonl");
  readStory(readSessionEvents(session_folder), so_far);
  countPulses(session_folder, so_far);
  if (const auto last = readLastFrame(session_folder / "poses.csv")) {
    so_far.last_frame = last->frame;
    so_far.last_t_s = last->t_s;
  }
  return so_far;
}

std::optional<SessionSoFar> newestSession(const fs::path& case_folder) {
  const auto folders = sessionFolders(case_folder);
  for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder)
    if (fs::exists(*folder / "events.jsonl")) return sessionSoFar(*folder);
  return std::nullopt;
}

}  // namespace facenav::casefile
