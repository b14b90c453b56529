#include "facenav/casefile/kept_session.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "appended_file.h"
#include "facenav/core/error.h"
#include "guided_time.h"
#include "json_lines.h"
#include "utc_now.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

void readEvents(const fs::path& file, std::vector<SessionEvent>& events, std::vector<std::string>& problems) {
  auto lines = readJsonLines(file);
  for (const JsonReader& line : lines.lines) {
    try {
      events.push_back({line.at("utc").text(), line.at("event").text(), line.at("detail").text()});
    } catch (const Error& fault) {
      problems.push_back(std::string(fault.what()) + ": the event is left out");
    }
  }
  for (auto& problem : lines.problems)
    if (std::find(problems.begin(), problems.end(), problem) == problems.end())
      problems.push_back(std::move(problem));
}

constexpr const char* kEvents = "events.jsonl";
constexpr const char* kNotes = "notes.jsonl";

/// Reads how long the session ran and guided; for an older session, from its tables.
void readTimes(const fs::path& session_folder, KeptSession& session) {
  const auto times = readSessionTimes(session_folder);
  if (!times) {
    session.duration_s = readDuration_s(session_folder / "poses.csv");
    session.guided = readGuidedTime(session_folder / "guidance.csv");
    return;
  }
  session.duration_s = times->running_s;
  session.paused_s = times->paused_s;
  session.away_s = times->away_s;
  if (times->guided.total_s() > 0) session.guided = times->guided;
}

/// Reads the times of an imported session. A damaged file leaves them absent; the session is still read.
void readReturned(const fs::path& file, KeptSession& session) {
  if (!fs::exists(file)) return;
  try {
    const JsonReader json = JsonReader::readFile(file);
    session.returned_utc = json.at("imported_utc").text();
    if (json.has("duration_s")) session.duration_s = json.at("duration_s").number();
    if (json.has("on_target_s"))
      session.guided = GuidedTime{json.at("on_target_s").number(), json.at("adjust_s").number(),
                                  json.at("lost_s").number()};
  } catch (const Error& error) {
    if (!session.returned_utc) session.returned_utc = "";
    session.pulses.problems.push_back(error.what());
  }
}

std::string namesOf(const std::vector<fs::path>& folders) {
  std::string names;
  for (const auto& folder : folders) names += (names.empty() ? "" : ", ") + folder.filename().string();
  return names;
}

}  // namespace

std::vector<fs::path> sessionFolders(const fs::path& case_folder) {
  std::vector<fs::path> folders;
  const fs::path sessions = case_folder / "sessions";
  if (!fs::is_directory(sessions)) return folders;
  for (const auto& entry : fs::directory_iterator(sessions))
    if (entry.is_directory() && entry.path().filename().string().front() != '.')
      folders.push_back(entry.path());
  std::sort(folders.begin(), folders.end());
  return folders;
}

fs::path findSession(const fs::path& case_folder, const std::string& name) {
  const auto folders = sessionFolders(case_folder);
  if (folders.empty()) throw Error("the case has no sessions", case_folder.string(), "treat it first");
  if (name.empty() || name == "newest") return folders.back();
  std::vector<fs::path> found;
  for (const auto& folder : folders) {
    const std::string of_folder = folder.filename().string();
    if (of_folder == name) return folder;
    if (of_folder.compare(0, name.size(), name) == 0) found.push_back(folder);
  }
  if (found.size() == 1) return found.front();
  throw Error(found.empty() ? "there is no session " + name : "several sessions start with " + name,
              case_folder.string(), "sessions: " + namesOf(found.empty() ? folders : found));
}

void addNote(const fs::path& session_folder, const std::string& event, const std::string& detail) {
  if (!fs::exists(session_folder / kEvents))
    throw Error("this is no session", session_folder.string(), "choose one of the case's sessions");
  const nlohmann::ordered_json line{{"utc", utcNow()}, {"event", event}, {"detail", detail}};
  AppendedFile file(session_folder / kNotes, "", AppendedFile::Start::old_or_fresh);
  file.append(line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  file.sync();
}

std::vector<SessionEvent> readSessionEvents(const fs::path& session_folder) {
  std::vector<SessionEvent> events;
  std::vector<std::string> ignored;
  readEvents(session_folder / kEvents, events, ignored);
  return events;
}

KeptSession readSession(const fs::path& session_folder) {
  KeptSession session;
  session.folder = session_folder;
  session.name = session_folder.filename().string();
  session.pulses = readSessionPulses(session_folder);
  std::vector<SessionEvent> events, notes;
  readEvents(session_folder / kEvents, events, session.pulses.problems);
  readEvents(session_folder / kNotes, notes, session.pulses.problems);
  // Keeps each file's own order, which is that of the events even if the clock was set back.
  std::merge(events.begin(), events.end(), notes.begin(), notes.end(), std::back_inserter(session.events),
             [](const SessionEvent& a, const SessionEvent& b) { return a.utc < b.utc; });
  readTimes(session_folder, session);
  readReturned(session_folder / kReturnedFile, session);
  return session;
}

}  // namespace facenav::casefile
