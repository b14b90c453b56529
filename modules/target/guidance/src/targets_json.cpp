#include <nlohmann/json.hpp>
#include <set>

#include "facenav/core/whole_file.h"
#include "facenav/geometry/json_transform.h"
#include "facenav/guidance/dose_json.h"
#include "facenav/guidance/target.h"

namespace facenav::guidance {
namespace {

using Json = nlohmann::ordered_json;

GridSpec readGrid(const JsonReader& json) {
  GridSpec grid;
  grid.rows = json.at("rows").integer();
  grid.columns = json.at("columns").integer();
  grid.spacing_mm = json.at("spacing_mm").number();
  const std::string on = json.at("on").text();
  if (on != "scalp" && on != "cortex") json.at("on").refuse("\"scalp\" or \"cortex\" was expected");
  grid.on = on == "scalp" ? GridOn::scalp : GridOn::cortex;
  return grid;
}

Json toJson(const GridSpec& grid) {
  return {{"rows", grid.rows},
          {"columns", grid.columns},
          {"spacing_mm", grid.spacing_mm},
          {"on", grid.on == GridOn::scalp ? "scalp" : "cortex"}};
}

GridPlace readGridPlace(const JsonReader& json) {
  GridPlace place;
  place.seed = json.at("seed").text();
  place.row = json.at("row").integer();
  place.column = json.at("column").integer();
  place.is_edited = json.has("edited");
  return place;
}

std::vector<Change> readChanges(const JsonReader& json) {
  std::vector<Change> changes;
  for (const JsonReader& change : json.elements())
    changes.push_back({change.at("utc").text(), change.at("by").text(), change.at("what").text()});
  return changes;
}

ExpertPose readExpert(const JsonReader& json) {
  ExpertPose expert;
  expert.session = json.at("session").text();
  expert.pulses = json.at("pulses").integer();
  expert.spread_mm = json.at("spread_mm").number();
  expert.spread_deg = json.at("spread_deg").number();
  if (json.has("predicted_error_mm")) expert.predicted_error_mm = json.at("predicted_error_mm").number();
  if (json.has("coil")) expert.coil = json.at("coil").text();
  return expert;
}

Json toJson(const ExpertPose& expert) {
  Json json{{"session", expert.session},
            {"pulses", expert.pulses},
            {"spread_mm", expert.spread_mm},
            {"spread_deg", expert.spread_deg}};
  if (expert.predicted_error_mm > 0) json["predicted_error_mm"] = expert.predicted_error_mm;
  if (!expert.coil.empty()) json["coil"] = expert.coil;
  return json;
}

/// Reads the members that older files lack.
void readRecord(const JsonReader& json, Target& target) {
  if (json.has("lift_mm")) target.lift_mm = json.at("lift_mm").number();
  target.is_locked = json.has("locked");
  if (json.has("dose")) target.dose = readDose(json.at("dose"));
  if (json.has("grid")) target.grid = readGrid(json.at("grid"));
  if (json.has("grid_place")) target.grid_place = readGridPlace(json.at("grid_place"));
  if (json.has("expert")) target.expert = readExpert(json.at("expert"));
  if (json.has("changes")) target.changes = readChanges(json.at("changes"));
}

/// Writes a member, or erases it if it has no value (an absent member means the default).
void setOrErase(Json& json, const char* key, const std::optional<Json>& value) {
  if (value)
    json[key] = *value;
  else
    json.erase(key);
}

Json doseJson(const Dose& dose) {
  Json json = Json::object();
  for (const auto& [key, value] : doseNumbers(dose))
    value == double(int(value)) ? json[key] = int(value) : json[key] = value;
  return json;
}

void writeRecord(const Target& target, Json& json) {
  using Value = std::optional<Json>;
  setOrErase(json, "lift_mm", target.lift_mm > 0 ? Value(target.lift_mm) : std::nullopt);
  setOrErase(json, "locked", target.is_locked ? Value(true) : std::nullopt);
  setOrErase(json, "dose", target.dose ? Value(doseJson(*target.dose)) : std::nullopt);
  setOrErase(json, "grid", target.grid ? Value(toJson(*target.grid)) : std::nullopt);
  setOrErase(json, "expert", target.expert ? Value(toJson(*target.expert)) : std::nullopt);
  Value place, changes;
  if (const auto& p = target.grid_place)
    place = Json{{"seed", p->seed}, {"row", p->row}, {"column", p->column}};
  if (place && target.grid_place->is_edited) (*place)["edited"] = true;
  setOrErase(json, "grid_place", place);
  if (!target.changes.empty()) changes = Json::array();
  for (const Change& change : target.changes)
    changes->push_back({{"utc", change.utc}, {"by", change.by}, {"what", change.what}});
  setOrErase(json, "changes", changes);
}

Target readTarget(const JsonReader& json) {
  Target target;
  target.name = json.at("name").text();
  if (target.name.empty()) json.at("name").refuse("a target needs a name");
  target.mri_T_target = readTransform<Mri, frames::Target>(json.at("mri_T_target"));
  target.cortex_point = readPoint<Mri>(json.at("cortex_point_mm"));
  target.scalp_point = readPoint<Mri>(json.at("scalp_point_mm"));
  if (json.has("note")) target.note = json.at("note").text();
  readRecord(json, target);
  return target;
}

/// Reads the file that will be replaced, for its keys unknown to FaceNav; empty if it cannot be read.
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
    writeRecord(target, json);
    targets.push_back(json);
  }
  file["targets"] = targets;
  writeWholeFile(path, file.dump(1, ' ', false, Json::error_handler_t::replace) + "\n", access);
}

}  // namespace facenav::guidance
