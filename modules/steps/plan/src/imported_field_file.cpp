#include "imported_field_file.h"

#include <nlohmann/json.hpp>

#include "facenav/core/error.h"
#include "facenav/core/json_reader.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"
#include "facenav/geometry/json_transform.h"
#include "facenav/geometry/pose_error.h"

namespace facenav::steps {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double kSamePlace_mm = 0.05, kSameTurn_deg = 0.05;  // differences below come from digits

fs::path listFile(const casefile::CaseStore& store) { return store.folder() / "imported_fields.json"; }

ImportedField readField(const JsonReader& json) {
  ImportedField field;
  field.target = json.at("target").text();
  field.mri_T_target = readTransform<Mri, frames::Target>(json.at("mri_T_target"));
  field.words = json.at("words").text();
  field.rate_A_per_us = json.at("rate_A_per_us").number();
  if (!(field.rate_A_per_us > 0)) json.at("rate_A_per_us").refuse("a number above 0 was expected");
  field.peak = json.at("peak_V_per_m").number();
  field.percentile_99_9 = json.at("percentile_99_9_V_per_m").number();
  field.peak_place = readPoint<Mri>(json.at("peak_mm"));
  field.has_directions = json.at("has_directions").integer() != 0;
  field.fills_brain = json.at("fills_brain").integer() != 0;
  for (const auto& note : json.at("notes").elements()) field.notes.push_back(note.text());
  field.utc = json.at("utc").text();
  field.file = json.at("file").text();
  if (fs::path(field.file).filename() != field.file || field.file.rfind("imported_field_", 0) != 0)
    json.at("file").refuse("a name such as imported_field_1.msh was expected");
  return field;
}

Json jsonOf(const ImportedField& field) {
  return {{"target", field.target},
          {"mri_T_target", rowMajor(field.mri_T_target)},
          {"words", field.words},
          {"rate_A_per_us", field.rate_A_per_us},
          {"peak_V_per_m", field.peak},
          {"percentile_99_9_V_per_m", field.percentile_99_9},
          {"peak_mm", rowMajor(field.peak_place)},
          {"has_directions", int(field.has_directions)},
          {"fills_brain", int(field.fills_brain)},
          {"notes", field.notes},
          {"utc", field.utc},
          {"file", field.file}};
}

std::string freeName(const casefile::CaseStore& store) {
  for (int number = 1;; ++number) {
    const std::string name = formatted("imported_field_%d.msh", number);
    if (!fs::exists(store.folder() / name)) return name;
  }
}

}  // namespace

bool isSamePlace(const RigidTransform<Mri, frames::Target>& a, const RigidTransform<Mri, frames::Target>& b) {
  const auto error = poseError(a, b);
  return error.translation_mm < kSamePlace_mm && error.rotation_rad * kDegPerRad < kSameTurn_deg;
}

std::vector<ImportedField> importedFields(const casefile::CaseStore& store) {
  std::vector<ImportedField> fields;
  if (!fs::exists(listFile(store))) return fields;
  for (const auto& json : JsonReader::readFile(listFile(store)).at("fields").elements())
    fields.push_back(readField(json));
  return fields;
}

std::optional<ImportedField> importedField(const casefile::CaseStore& store, const guidance::Target& target) {
  for (const auto& field : importedFields(store))
    if (field.target == target.name && isSamePlace(field.mri_T_target, target.mri_T_target)) return field;
  return std::nullopt;
}

void keepImportedField(const casefile::CaseStore& store, ImportedField& field,
                       const efield::FieldSamples& samples) {
  field.file = freeName(store);
  efield::writeFieldPointsMsh(samples, store.folder() / field.file);
  Json list = Json::array();
  std::vector<std::string> old_files;
  for (const auto& other : importedFields(store))
    if (other.target == field.target)
      old_files.push_back(other.file);
    else
      list.push_back(jsonOf(other));
  list.push_back(jsonOf(field));
  const Json json{{"schema_version", 1}, {"fields", list}};
  writeWholeFile(listFile(store), json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n",
                 FileAccess::owner_only);
  std::error_code ignored;
  for (const auto& name : old_files) fs::remove(store.folder() / name, ignored);
}

}  // namespace facenav::steps
