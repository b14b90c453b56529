#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/plain_words.h"
#include "facenav/core/whole_file.h"
#include "facenav/geometry/json_transform.h"
#include "facenav/guidance/dose_json.h"
#include "facenav/guidance/target.h"
#include "targets_rescue.h"

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
  target.mri_T_target = readTransform<Mri, frames::Target>(json.at("mri_T_target"));
  target.cortex_point = readPoint<Mri>(json.at("cortex_point_mm"));
  target.scalp_point = readPoint<Mri>(json.at("scalp_point_mm"));
  if (json.has("note")) target.note = json.at("note").text();
  readRecord(json, target);
  try {
    requireSound(target);
  } catch (const Error& fault) {
    json.refuse(fault.what());
  }
  return target;
}

/// Reads the file, or what can be rescued of it; `damaged` tells of the rescue.
JsonReader readRescued(const std::filesystem::path& path, std::vector<std::string>& damaged) {
  try {
    return JsonReader::readFile(path);
  } catch (const Error& fault) {
    const std::string rescued =
        std::filesystem::is_regular_file(path) ? rescuedTargets(readWholeFile(path)) : std::string();
    if (rescued.empty()) throw;
    damaged.push_back(std::string("the plan is damaged, what can be read of it is used: ") + fault.what());
    return JsonReader::readText(rescued, path);
  }
}

/// Keeps a damaged file under another name before it is replaced.
void keepDamaged(const std::filesystem::path& path, FileAccess access) {
  if (!std::filesystem::is_regular_file(path)) return;
  try {
    if (readTargets(path).damaged.empty()) return;
  } catch (const Error&) {  // nothing of it can be read
  }
  const std::string content = readWholeFile(path);
  if (!content.empty()) writeWholeFile(path.parent_path() / "targets_damaged.json", content, access);
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
  const std::string also = damaged.empty() ? "" : " (" + damaged.front() + ")";
  throw Error("there is no target named '" + name + "'" + also, {},
              known.empty() ? "plan a target first" : "choose one of: " + known);
}

void requireSound(const Target& target) {
  constexpr double kFarthestFromHead_mm = 1000;
  requireName(target.name, "the target's name");
  const auto refuse = [&](const std::string& what) {
    throw Error("the target '" + target.name + "' cannot be kept: " + what, {}, "check what was typed");
  };
  const auto isNear = [](const auto& mm) {
    return mm.allFinite() && mm.cwiseAbs().maxCoeff() <= kFarthestFromHead_mm;
  };
  if (!target.mri_T_target.matrix().allFinite() || !isNear(target.mri_T_target.translation_mm()))
    refuse("its pose is no place near the head");
  if (!isNear(target.cortex_point.mm) || !isNear(target.scalp_point.mm))
    refuse("its points are no places near the head");
  if (!(std::abs(target.lift_mm) <= kFarthestFromHead_mm)) refuse("its lift is no height");
  requireNote(target.note, "the note of the target '" + target.name + "'");
  if (target.dose) requireSensible(*target.dose);
  if (target.grid && !(target.grid->spacing_mm > 0 && target.grid->spacing_mm <= kFarthestFromHead_mm))
    refuse("its grid has no spacing");
  if (const auto& expert = target.expert)
    for (const double value : {expert->spread_mm, expert->spread_deg, expert->predicted_error_mm})
      if (!isUsableNumber(value)) refuse("the spread of its pulses is no number");
}

TreatmentPlan readTargets(const std::filesystem::path& path) {
  TreatmentPlan plan;
  std::set<std::string> names;
  for (const JsonReader& json : readRescued(path, plan.damaged).at("targets").elements()) {
    try {
      Target target = readTarget(json);
      if (!names.insert(target.name).second) json.at("name").refuse("two targets have the same name");
      plan.targets.push_back(std::move(target));
    } catch (const Error& fault) {
      plan.damaged.push_back(std::string("a target is left out: ") + fault.what());
    }
  }
  return plan;
}

void writeTargets(const TreatmentPlan& plan, const std::filesystem::path& path, FileAccess access) {
  for (const Target& target : plan.targets) requireSound(target);
  keepDamaged(path, access);
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
