#include "rig_json.h"

#include <nlohmann/json.hpp>

#include "facenav/capture/stream_logins.h"
#include "facenav/core/json_reader.h"
#include "facenav/core/shown_address.h"

namespace facenav::capture {
namespace {

using Json = nlohmann::ordered_json;

struct SettingKey {
  const char* key;
  std::optional<double> CameraSettings::*value;
};
constexpr SettingKey kSettingKeys[] = {{"exposure_ms", &CameraSettings::exposure_ms},
                                       {"gain", &CameraSettings::gain},
                                       {"focus", &CameraSettings::focus},
                                       {"white_balance_k", &CameraSettings::white_balance_k}};
constexpr double kMicro = 1e6;  // us per s
constexpr const char* kTriggers[] = {"free_run", "software", "hardware"};

Json cameraJson(const RigCamera& camera) {
  const CameraIdentity& identity = camera.identity;
  const CameraSettings& settings = camera.settings;
  Json json = {{"connection", identity.backend}, {"address", shownAddress(identity.address)},
               {"model", identity.model},        {"serial", identity.serial},
               {"port", identity.port},          {"frames_per_s", settings.frames_per_s},
               {"format", settings.format},      {"trigger", kTriggers[int(settings.trigger)]}};
  for (const auto& [key, value] : kSettingKeys)
    if (settings.*value) json[key] = *(settings.*value);
  return json;
}

Trigger triggerOf(const JsonReader& json) {
  for (int i = 0; i < 3; ++i)
    if (json.text() == kTriggers[i]) return Trigger(i);
  json.refuse("is no trigger: free_run, software or hardware");
}

RigCamera readCamera(const JsonReader& json) {
  RigCamera camera;
  camera.identity = {json.at("connection").text(), json.at("address").text(), json.at("model").text(),
                     json.at("serial").text(), json.at("port").text()};
  if (camera.identity.backend == "stream") camera.identity = streamIdentity(camera.identity.address);
  camera.settings.frames_per_s = json.at("frames_per_s").number();
  if (!(camera.settings.frames_per_s > 0)) json.at("frames_per_s").refuse("must be more than 0");
  camera.settings.format = json.at("format").text();
  camera.settings.trigger = triggerOf(json.at("trigger"));
  for (const auto& [key, value] : kSettingKeys)
    if (json.has(key)) camera.settings.*value = json.at(key).number();
  return camera;
}

}  // namespace

std::string toRigJson(const NamedRig& rig) {
  Json json = {{"version", 1}, {"name", rig.name}, {"created", rig.created_utc}};
  if (rig.left && rig.right) {
    json["left"] = cameraJson(*rig.left);
    json["right"] = cameraJson(*rig.right);
  }
  if (rig.uncertainty)
    json["uncertainty"] = {{"distance_mm", rig.uncertainty->distance_mm},
                           {"point_mm", rig.uncertainty->point_mm}};
  if (rig.last_check)
    json["last_check"] = {
        {"utc", rig.last_check->utc}, {"state", rig.last_check->state}, {"words", rig.last_check->words}};
  if (rig.row_times)
    json["row_times"] = {{"utc", rig.row_times->utc},
                         {"left_us", kMicro * rig.row_times->left_s},
                         {"right_us", kMicro * rig.row_times->right_s}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

NamedRig readRigJson(const std::filesystem::path& path) {
  const JsonReader json = JsonReader::readFile(path);
  if (json.at("version").integer() != 1) json.at("version").refuse("is of a newer program");
  NamedRig rig;
  rig.name = json.at("name").text();
  rig.created_utc = json.at("created").text();
  if (json.has("left") || json.has("right")) {
    rig.left = readCamera(json.at("left"));
    rig.right = readCamera(json.at("right"));
  }
  if (json.has("uncertainty")) {
    const JsonReader error = json.at("uncertainty");
    rig.uncertainty = RigUncertainty_mm{error.at("distance_mm").number(), error.at("point_mm").number()};
  }
  if (json.has("last_check")) {
    const JsonReader check = json.at("last_check");
    rig.last_check = RigCheckNote{check.at("utc").text(), check.at("state").text(), check.at("words").text()};
  }
  if (json.has("row_times")) {
    const JsonReader times = json.at("row_times");
    rig.row_times = MeasuredRowTimes{times.at("utc").text(), times.at("left_us").number() / kMicro,
                                     times.at("right_us").number() / kMicro};
  }
  return rig;
}

}  // namespace facenav::capture
