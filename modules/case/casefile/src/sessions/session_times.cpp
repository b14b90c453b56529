#include "facenav/casefile/session_times.h"

#include <nlohmann/json.hpp>

#include "facenav/core/error.h"
#include "facenav/core/json_reader.h"
#include "facenav/core/log.h"
#include "facenav/core/whole_file.h"

namespace facenav::casefile {
namespace {

constexpr const char* kName = "times.json";

double seconds(const JsonReader& json, const char* key) {
  const double value_s = json.at(key).number();
  if (value_s < 0) json.at(key).refuse("a duration is not negative");
  return value_s;
}

}  // namespace

void writeSessionTimes(const SessionTimes& times, const std::filesystem::path& session_folder) {
  const nlohmann::ordered_json json{{"running_s", times.running_s},
                                    {"paused_s", times.paused_s},
                                    {"away_s", times.away_s},
                                    {"on_target_s", times.guided.on_target_s},
                                    {"adjust_s", times.guided.adjust_s},
                                    {"lost_s", times.guided.lost_s}};
  if (!std::filesystem::exists(session_folder))
    throw Error("the session's folder was removed", session_folder.string());
  writeWholeFile(session_folder / kName, json.dump(1) + "\n", FileAccess::owner_only);
}

std::optional<SessionTimes> readSessionTimes(const std::filesystem::path& session_folder) {
  if (!std::filesystem::exists(session_folder / kName)) return std::nullopt;
  try {
    const JsonReader json = JsonReader::readFile(session_folder / kName);
    return SessionTimes{seconds(json, "running_s"),
                        seconds(json, "paused_s"),
                        seconds(json, "away_s"),
                        {seconds(json, "on_target_s"), seconds(json, "adjust_s"), seconds(json, "lost_s")}};
  } catch (const Error& error) {  // the tables still tell the times
    logWarning(error.what());
    return std::nullopt;
  }
}

}  // namespace facenav::casefile
