#include "facenav/casefile/twitches.h"

#include <nlohmann/json.hpp>

#include "appended_file.h"
#include "facenav/core/error.h"
#include "facenav/core/utc_time.h"
#include "json_lines.h"

namespace facenav::casefile {
namespace {

constexpr const char* kPulseEdits = "pulse_edits.jsonl";
constexpr const char* kTakenBack = "twitch taken back";

}  // namespace

void keepTwitch(const std::filesystem::path& session_folder, int pulse, std::optional<bool> has_twitched) {
  nlohmann::ordered_json line{{"utc", isoUtc(std::chrono::system_clock::now())},
                              {"pulse", pulse},
                              {"change", has_twitched ? "twitch" : kTakenBack}};
  if (has_twitched) line["twitch"] = *has_twitched ? 1 : 0;
  AppendedFile file(session_folder / kPulseEdits, "", AppendedFile::Start::old_or_fresh);
  file.append(line.dump() + "\n");
  file.sync();
}

std::map<int, bool> readTwitches(const std::filesystem::path& session_folder) {
  std::map<int, bool> twitches;
  for (const JsonReader& line : readJsonLines(session_folder / kPulseEdits).lines) {
    try {
      const std::string change = line.at("change").text();
      if (change == "twitch") twitches[line.at("pulse").integer()] = line.at("twitch").integer() != 0;
      if (change == kTakenBack) twitches.erase(line.at("pulse").integer());
    } catch (const Error&) {  // another reader names damaged lines (session_pulses.h)
    }
  }
  return twitches;
}

}  // namespace facenav::casefile
