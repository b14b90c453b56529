#include "support/session_outline.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "facenav/casefile/kept_session.h"
#include "facenav/core/csv_table.h"
#include "facenav/core/utc_time.h"
#include "support/case_files.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostEvents = 2000;

/// Events whose details the program words itself. Another event is named if it is in
/// resources/doc/formats.md, without detail.
const std::set<std::string> kWorded{
    "fault",           "camera moved",       "cameras back", "alignment caution", "face lost",
    "coil lost",       "log resumed",        "clock set",    "recording ended",   "double trigger",
    "changed_setting", "registration check", "session ended"};
const std::set<std::string> kNamed{
    "session started", "session continued", "target",      "coil",       "coil followed", "coil calibration",
    "coil focus",      "other coil",        "alignment",   "protocol",   "override",      "pause",
    "resume",          "pause length",      "face found",  "coil found", "tip check",     "pulse source",
    "pulse pictures",  "threshold",         "pain before", "pain after", "adverse event", "operator",
    "muscle",          "stimulator",        "at home",     "pulse"};

Json eventsOf(const casefile::KeptSession& session, const Scrubber& scrubber) {
  Json list = Json::array();
  std::optional<double> start_s;
  for (const auto& event : session.events)
    if (const auto time_s = secondsOfUtc(event.utc)) start_s = std::min(start_s.value_or(*time_s), *time_s);
  for (const auto& event : session.events) {
    if (list.size() == kMostEvents) break;
    const auto time_s = secondsOfUtc(event.utc);
    const bool is_worded = kWorded.count(event.event) > 0;
    Json entry{{"event", is_worded || kNamed.count(event.event) ? event.event : "[other]"}};
    if (time_s && start_s) entry["t_s"] = std::round(10 * (*time_s - *start_s)) / 10;
    if (is_worded && !event.detail.empty()) entry["detail"] = scrubber.scrubbed(event.detail);
    list.push_back(entry);
  }
  return list;
}

/// "head tracked", "coil lost no_marker" -> number of rows.
Json posesOf(const fs::path& file) {
  const CsvTable table(file);
  const auto object = table.column("object"), status = table.column("status"),
             reason = table.column("reason");
  std::map<std::string, int> counts;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string words = table.text(row, object) + " " + table.text(row, status);
    const std::string& why = table.text(row, reason);
    ++counts[why.empty() ? words : words + " " + why];
  }
  return counts;
}

}  // namespace

Json sessionOutline(const fs::path& session_folder, const Scrubber& scrubber) {
  Json outline{{"files", filesOfCase(session_folder)}};
  try {
    const auto session = casefile::readSession(session_folder);
    if (session.duration_s) outline["duration_s"] = *session.duration_s;
    if (session.paused_s) outline["paused_s"] = *session.paused_s;
    std::map<std::string, int> pulses;
    for (const auto& each : session.pulses.pulses) ++pulses[each.is_excluded ? "excluded" : "counted"];
    outline["pulses"] = pulses;
    outline["damaged lines"] = session.pulses.problems.size();
    outline["events"] = eventsOf(session, scrubber);
  } catch (const std::exception& error) {
    outline["fault"] = scrubber.scrubbed(error.what());
  }
  try {
    if (fs::exists(session_folder / "poses.csv")) outline["poses"] = posesOf(session_folder / "poses.csv");
  } catch (const std::exception& error) {
    outline["fault of poses.csv"] = scrubber.scrubbed(error.what());
  }
  return outline;
}

}  // namespace facenav::app
