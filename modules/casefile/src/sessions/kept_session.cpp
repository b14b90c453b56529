#include "facenav/casefile/kept_session.h"

#include <algorithm>

#include "facenav/core/error.h"
#include "guided_time.h"
#include "json_lines.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

std::vector<SessionEvent> readEvents(const fs::path& folder, std::vector<std::string>& problems) {
  std::vector<SessionEvent> events;
  auto lines = readJsonLines(folder / "events.jsonl");
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
  return events;
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
  if (name.empty()) return folders.back();
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

KeptSession readSession(const fs::path& session_folder) {
  KeptSession session;
  session.folder = session_folder;
  session.name = session_folder.filename().string();
  session.pulses = readSessionPulses(session_folder);
  session.events = readEvents(session_folder, session.pulses.problems);
  session.duration_s = readDuration_s(session_folder / "poses.csv");
  session.guided = readGuidedTime(session_folder / "guidance.csv");
  return session;
}

}  // namespace facenav::casefile
