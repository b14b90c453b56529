#include <nlohmann/json.hpp>
#include <set>

#include "facenav/core/whole_file.h"
#include "facenav/geometry/json_transform.h"
#include "facenav/guidance/target.h"

namespace facenav::guidance {
namespace {

using Json = nlohmann::ordered_json;

Target readTarget(const JsonReader& json) {
  Target target;
  target.name = json.at("name").text();
  if (target.name.empty()) json.at("name").refuse("a target needs a name");
  target.mri_T_target = readTransform<Mri, frames::Target>(json.at("mri_T_target"));
  target.cortex_point = readPoint<Mri>(json.at("cortex_point_mm"));
  target.scalp_point = readPoint<Mri>(json.at("scalp_point_mm"));
  if (json.has("note")) target.note = json.at("note").text();
  return target;
}

/// Content of the file that will be replaced, for the keys unknown to FaceNav; empty if it cannot be read.
Json previousContent(const std::filesystem::path& path) {
  try {
    Json json = Json::parse(readWholeFile(path));
    return json.is_object() ? json : Json::object();
  } catch (const std::exception&) {
    return Json::object();
  }
}

Json previousTarget(const Json& file, const std::string& name) {
  if (file.contains("targets") && file["targets"].is_array())
    for (const Json& target : file["targets"])
      if (target.is_object() && target.contains("name") && target["name"] == name) return target;
  return Json::object();
}

}  // namespace

const Target& TreatmentPlan::find(const std::string& name) const {
  std::string known;
  for (const Target& target : targets) {
    if (target.name == name) return target;
    known += (known.empty() ? "'" : ", '") + target.name + "'";
  }
  throw Error("there is no target named '" + name + "'", {},
              known.empty() ? "plan a target first" : "choose one of: " + known);
}

TreatmentPlan readTargets(const std::filesystem::path& path) {
  TreatmentPlan plan;
  std::set<std::string> names;
  for (const JsonReader& json : JsonReader::readFile(path).at("targets").elements()) {
    plan.targets.push_back(readTarget(json));
    if (!names.insert(plan.targets.back().name).second)
      json.at("name").refuse("two targets have the same name");
  }
  return plan;
}

void writeTargets(const TreatmentPlan& plan, const std::filesystem::path& path, FileAccess access) {
  Json file = previousContent(path), targets = Json::array();
  for (const Target& target : plan.targets) {
    Json json = previousTarget(file, target.name);
    json["name"] = target.name;
    json["mri_T_target"] = rowMajor(target.mri_T_target);
    json["cortex_point_mm"] = rowMajor(target.cortex_point);
    json["scalp_point_mm"] = rowMajor(target.scalp_point);
    json["note"] = target.note;
    targets.push_back(json);
  }
  file["targets"] = targets;
  writeWholeFile(path, file.dump(1, ' ', false, Json::error_handler_t::replace) + "\n", access);
}

}  // namespace facenav::guidance
