#include "case_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "facenav/core/error.h"
#include "facenav/core/json_reader.h"
#include "facenav/core/whole_file.h"

namespace facenav::casefile {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> readTexts(const JsonReader& json) {
  std::vector<std::string> texts;
  for (const JsonReader& element : json.elements()) texts.push_back(element.text());
  return texts;
}

std::map<std::string, std::string> readTextMap(const JsonReader& json) {
  std::map<std::string, std::string> texts;
  for (const auto& [key, value] : json.members()) texts[key] = value.text();
  return texts;
}

Provenance readProvenance(const JsonReader& json) {
  Provenance step{json.at("step").text(), json.at("software_version").text(), {}, {}, {}};
  if (json.has("options")) step.options = readTextMap(json.at("options"));
  if (json.has("input_sha256")) step.input_sha256 = readTextMap(json.at("input_sha256"));
  if (json.has("settings")) step.settings = readSettings(json.at("settings"));
  return step;
}

BrainQuality readBrainQuality(const JsonReader& json) {
  BrainQuality quality;
  quality.surface_median_mm = json.at("surface_median_mm").number();
  quality.surface_p95_mm = json.at("surface_p95_mm").number();
  if (json.has("model_median_mm")) quality.model_median_mm = json.at("model_median_mm").number();
  if (json.has("model_p95_mm")) quality.model_p95_mm = json.at("model_p95_mm").number();
  for (const JsonReader& region : json.at("regions").elements())
    quality.regions.push_back(
        {region.at("region").text(), region.at("confidence").number(), region.at("doubt_mm").number()});
  return quality;
}

double rounded(double value, double per_unit) { return std::round(value * per_unit) / per_unit; }

Json toJson(const BrainQuality& quality) {
  Json regions = Json::array();
  for (const RegionConfidence& r : quality.regions)
    regions.push_back({{"region", r.region},
                       {"confidence", rounded(r.confidence, 1000)},
                       {"doubt_mm", rounded(r.doubt_mm, 100)}});
  return {{"surface_median_mm", rounded(quality.surface_median_mm, 100)},
          {"surface_p95_mm", rounded(quality.surface_p95_mm, 100)},
          {"model_median_mm", rounded(quality.model_median_mm, 100)},
          {"model_p95_mm", rounded(quality.model_p95_mm, 100)},
          {"regions", regions}};
}

Json toJson(const Provenance& step) {
  Json json{{"step", step.step},
            {"software_version", step.software_version},
            {"options", step.options},
            {"input_sha256", step.input_sha256}};
  if (!step.settings.empty()) json["settings"] = step.settings;
  return json;
}

void refuseNewer(int version, const std::filesystem::path& path) {
  if (version <= kSchemaVersion) return;
  throw Error("schema version " + std::to_string(version) +
                  ": this case was written by a newer FaceNav and was not changed",
              path.string(), "update FaceNav");
}

void requireVersion(const std::filesystem::path& path, const JsonReader& json) {
  const int version = json.at("schema_version").integer();
  refuseNewer(version, path);
  if (version < kSchemaVersion)
    json.at("schema_version")
        .refuse("schema version " + std::to_string(version) + " is not known, this FaceNav reads " +
                std::to_string(kSchemaVersion) + "; prepare the case again");
}

/// Throws Error unless each name is a file inside the case; no path may lead out of it.
void requireInside(const JsonReader& file) {
  const std::filesystem::path path = file.text();
  if (path.empty() || path.has_parent_path() || path == "..")
    file.refuse("a file name inside the case was expected");
}

}  // namespace

SettingValues readSettings(const JsonReader& json) {
  SettingValues settings;
  for (const auto& [key, value] : json.members()) settings[key] = value.number();
  return settings;
}

void requireNotNewer(const std::filesystem::path& path) {
  int version = 0;
  try {
    version = JsonReader::readFile(path).at("schema_version").integer();
  } catch (const Error&) {
    return;  // damaged: whoever reads it says so
  }
  refuseNewer(version, path);
}

CaseJson readCaseJson(const std::filesystem::path& path) {
  const JsonReader json = JsonReader::readFile(path);
  requireVersion(path, json);
  CaseJson content;
  content.case_id = json.at("case_id").text();
  if (json.has("label")) content.label = json.at("label").text();
  if (json.has("created_utc")) content.created_utc = json.at("created_utc").text();
  if (json.has("mri")) {
    if (json.at("mri").has("modality")) content.modality = json.at("mri").at("modality").text();
    if (json.at("mri").has("orientation_source"))
      content.orientation_source = json.at("mri").at("orientation_source").text();
  }
  content.files = {"mri.nii.gz", "head_mask.nii.gz", "scalp.vtp"};
  if (json.has("files")) {
    for (const JsonReader& file : json.at("files").elements()) requireInside(file);
    content.files = readTexts(json.at("files"));
  }
  if (json.has("findings")) content.findings = readTexts(json.at("findings"));
  if (json.has("brain_quality")) content.brain_quality = readBrainQuality(json.at("brain_quality"));
  if (json.has("provenance"))
    for (const JsonReader& step : json.at("provenance").elements())
      content.provenance.push_back(readProvenance(step));
  return content;
}

void writeCaseJson(const CaseJson& content, const std::filesystem::path& path) {
  Json json;
  json["schema_version"] = kSchemaVersion;
  json["case_id"] = content.case_id;
  if (!content.label.empty()) json["label"] = content.label;
  json["created_utc"] = content.created_utc;
  if (!content.modality.empty() || !content.orientation_source.empty())
    json["mri"] = {{"modality", content.modality}, {"orientation_source", content.orientation_source}};
  json["files"] = content.files;
  json["findings"] = content.findings;
  if (content.brain_quality) json["brain_quality"] = toJson(*content.brain_quality);
  json["provenance"] = Json::array();
  for (const Provenance& step : content.provenance) json["provenance"].push_back(toJson(step));
  writeWholeFile(path, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n",
                 FileAccess::owner_only);
}

std::string makeCaseId() {
  std::random_device random;
  std::string id;
  for (int i = 0; i < 16; ++i) id += "0123456789abcdef"[random() & 15];
  return id;
}

}  // namespace facenav::casefile
