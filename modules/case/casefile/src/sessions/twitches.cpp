#include "facenav/casefile/twitches.h"

#include <nlohmann/json.hpp>

#include "appended_file.h"
#include "facenav/core/error.h"
#include "facenav/core/utc_time.h"
#include "json_lines.h"

namespace facenav::casefile {
namespace {

constexpr const char* kPulseEdits = "pulse_edits.jsonl";

}  // namespace

void keepTwitch(const std::filesystem::path& session_folder, int pulse, bool has_twitched) {
  const nlohmann::ordered_json line{{"utc", isoUtc(std::chrono::system_clock::now())},
                                    {"pulse", pulse},
                                    {"change", "twitch"},
                                    {"twitch", has_twitched ? 1 : 0}};
  AppendedFile file(session_folder / kPulseEdits, "", AppendedFile::Start::old_or_fresh);
  file.append(line.dump() + "\n");
  file.sync();
}

std::map<int, bool> readTwitches(const std::filesystem::path& session_folder) {
  std::map<int, bool> twitches;
  for (const JsonReader& line : readJsonLines(session_folder / kPulseEdits).lines) {
    try {
      if (line.at("change").text() == "twitch")
        twitches[line.at("pulse").integer()] = line.at("twitch").integer() != 0;
    } catch (const Error&) {  // another reader names damaged lines (session_pulses.h)
    }
  }
  return twitches;
}

}  // namespace facenav::casefile
