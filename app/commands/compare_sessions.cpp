#include "commands/compare_sessions.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "facenav/casefile/case_store.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/core/number_text.h"
#include "facenav/review/session_compare.h"

namespace facenav::app {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const steps::MeanCoil& mean) {
  return {{"pulses", mean.pulses}, {"spread_mm", mean.spread_mm}, {"spread_deg", mean.spread_deg}};
}

Json toJson(const steps::TargetReturn& back) {
  return {{"target", back.target},
          {"distance_mm", back.distance_mm},
          {"tilt_deg", back.tilt_deg},
          {"twist_deg", back.twist_deg},
          {"angle_deg", back.angle_deg},
          {"target_moved_mm", back.target_moved_mm},
          {"target_turned_deg", back.target_turned_deg},
          {"first", toJson(back.first)},
          {"second", toJson(back.second)},
          {"median_mep_first_uv", back.mep_first_uv ? Json(*back.mep_first_uv) : Json()},
          {"median_mep_second_uv", back.mep_second_uv ? Json(*back.mep_second_uv) : Json()}};
}

std::string spreadWords(const steps::MeanCoil& mean) {
  return formatted("%d pulses +-%.1f mm", mean.pulses, mean.spread_mm);
}

void print(const steps::SessionComparison& comparison) {
  std::printf("%-20s %8s %8s %8s %8s %20s %20s %14s\n", "target", "mm", "tilt", "twist", "rotation", "first",
              "second", "target moved");
  for (const auto& back : comparison.targets)
    std::printf("%-20s %8.2f %8.2f %8.2f %8.2f %20s %20s %11.2f mm\n", back.target.c_str(), back.distance_mm,
                back.tilt_deg, back.twist_deg, back.angle_deg, spreadWords(back.first).c_str(),
                spreadWords(back.second).c_str(), back.target_moved_mm);
  if (comparison.targets.empty()) std::printf("no target has pulses with a pose in both sessions\n");
  for (const auto& name : comparison.only_first) std::printf("only in the first: %s\n", name.c_str());
  for (const auto& name : comparison.only_second) std::printf("only in the second: %s\n", name.c_str());
}

}  // namespace

void compareSessions(const std::filesystem::path& case_folder, const std::string& first,
                     const std::string& second, bool is_json) {
  const auto folder = casefile::CaseStore::open(case_folder).folder();
  const auto first_folder = casefile::findSession(folder, first);
  const auto second_folder = casefile::findSession(folder, second);
  const auto comparison = steps::compareSessions(casefile::readSessionPulses(first_folder).pulses,
                                                 casefile::readSessionPulses(second_folder).pulses);
  if (!is_json) return print(comparison);
  Json json{{"first", first_folder.filename().string()}, {"second", second_folder.filename().string()}};
  json["targets"] = Json::array();
  for (const auto& back : comparison.targets) json["targets"].push_back(toJson(back));
  json["only_first"] = comparison.only_first;
  json["only_second"] = comparison.only_second;
  std::fputs((json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n").c_str(), stdout);
}

}  // namespace facenav::app
