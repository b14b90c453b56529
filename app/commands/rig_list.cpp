// facenav rig list.

#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands/rig_steps.h"

namespace facenav::app {
namespace {

using RigJson = nlohmann::ordered_json;

RigJson cameraEntry(const std::optional<capture::RigCamera>& camera) {
  return camera ? RigJson(capture::stableName(camera->identity)) : RigJson(nullptr);
}

RigJson entryJson(const capture::RigEntry& entry) {
  RigJson json = {{"name", entry.name}, {"folder", entry.folder.string()}};
  if (!entry.rig) {
    json["problem"] = entry.problem;
    return json;
  }
  const capture::NamedRig& rig = *entry.rig;
  json.update({{"created", rig.created_utc},
               {"left", cameraEntry(rig.left)},
               {"right", cameraEntry(rig.right)},
               {"width_px", rig.rig.width_px},
               {"height_px", rig.rig.height_px},
               {"baseline_mm", rig.rig.baseline_mm()}});
  if (rig.uncertainty)
    json.update(
        {{"distance_mm", rig.uncertainty->distance_mm}, {"uncertainty_mm", rig.uncertainty->point_mm}});
  if (rig.last_check)
    json["last_check"] = {
        {"utc", rig.last_check->utc}, {"state", rig.last_check->state}, {"words", rig.last_check->words}};
  if (rig.row_times)
    json["row_times"] = {{"utc", rig.row_times->utc},
                         {"left_us", 1e6 * rig.row_times->left_s},
                         {"right_us", 1e6 * rig.row_times->right_s}};
  return json;
}

void printEntry(const capture::RigEntry& entry) {
  if (!entry.rig)
    return void(std::printf("%-20s unreadable: %s\n", entry.name.c_str(), entry.problem.c_str()));
  const capture::NamedRig& rig = *entry.rig;
  std::printf("%-20s %s  %d x %d px, %.1f mm apart, %s\n", entry.name.c_str(), rig.created_utc.c_str(),
              rig.rig.width_px, rig.rig.height_px, rig.rig.baseline_mm(), uncertaintyInWords(rig).c_str());
  for (const auto& [side, camera] : {std::pair("left", &rig.left), std::pair("right", &rig.right)})
    std::printf("  %-5s %s\n", side,
                *camera ? capture::inWords((*camera)->identity).c_str() : "no camera: made from files");
  if (rig.row_times)
    std::printf("  rolling shutter, measured %s: a picture is read in %.1f ms (left), %.1f ms (right)\n",
                rig.row_times->utc.c_str(), 1e3 * rig.row_times->left_s * rig.rig.height_px,
                1e3 * rig.row_times->right_s * rig.rig.height_px);
  if (rig.last_check)
    std::printf("  checked %s: %s\n", rig.last_check->utc.c_str(), rig.last_check->words.c_str());
  else
    std::printf("  never checked\n");
}

}  // namespace

void listRigs(const RigRequest& request) {
  const capture::RigStore store(request.rigs);
  const auto entries = store.list();
  if (request.is_json) {
    RigJson list = RigJson::array();
    for (const auto& entry : entries) list.push_back(entryJson(entry));
    std::printf("%s\n", list.dump(1, ' ', false, RigJson::error_handler_t::replace).c_str());
    return;
  }
  for (const auto& entry : entries) printEntry(entry);
  if (entries.empty()) std::printf("no rig in %s; make one with: facenav rig new\n", store.folder().c_str());
}

}  // namespace facenav::app
