#include <nlohmann/json.hpp>

#include "facenav/casefile/case_store.h"
#include "facenav/core/whole_file.h"
#include "facenav/geometry/json_transform.h"

namespace facenav::casefile {
namespace {

double atLeastZero(const JsonReader& json) {
  const double value = json.number();
  if (value < 0) json.refuse("a number >= 0 was expected");
  return value;
}

}  // namespace

StoredAlignment toStored(const registration::AlignmentResult& result, const guidance::TreatmentPlan& plan) {
  StoredAlignment stored{result.camera_T_mri,
                         result.rms_mm,
                         result.max_mm,
                         result.inlier_fraction,
                         result.points,
                         {},
                         {},
                         result.face_scale,
                         result.face_scale_sigma,
                         result.cautions};
  for (const guidance::Target& target : plan.targets) {
    stored.predicted_tre_mm[target.name] = result.predictedError_mm(target.cortex_point);
    stored.predicted_tre_p95_mm[target.name] = result.errorBound_mm(target.cortex_point);
  }
  return stored;
}

void writeAlignment(const StoredAlignment& alignment, const std::filesystem::path& path) {
  nlohmann::ordered_json json;
  json["camera_T_mri"] = rowMajor(alignment.camera_T_mri);
  json["rms_mm"] = alignment.rms_mm;
  json["max_mm"] = alignment.max_mm;
  json["inlier_fraction"] = alignment.inlier_fraction;
  json["points"] = alignment.points;
  json["predicted_tre_mm"] = alignment.predicted_tre_mm;
  if (!alignment.predicted_tre_p95_mm.empty()) json["predicted_tre_p95_mm"] = alignment.predicted_tre_p95_mm;
  if (alignment.face_scale_sigma > 0) {
    json["face_scale"] = alignment.face_scale;
    json["face_scale_sigma"] = alignment.face_scale_sigma;
  }
  if (!alignment.cautions.empty()) json["cautions"] = alignment.cautions;
  writeWholeFile(path, json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n",
                 FileAccess::owner_only);
}

StoredAlignment readAlignment(const std::filesystem::path& path) {
  const JsonReader json = JsonReader::readFile(path);
  StoredAlignment alignment;
  alignment.camera_T_mri = readTransform<Camera, Mri>(json.at("camera_T_mri"));
  alignment.rms_mm = atLeastZero(json.at("rms_mm"));
  alignment.max_mm = atLeastZero(json.at("max_mm"));
  alignment.inlier_fraction = atLeastZero(json.at("inlier_fraction"));
  if (alignment.inlier_fraction > 1) json.at("inlier_fraction").refuse("a number in 0..1 was expected");
  alignment.points = json.at("points").integer();
  for (const auto& [key, map] : {std::pair{"predicted_tre_mm", &alignment.predicted_tre_mm},
                                 std::pair{"predicted_tre_p95_mm", &alignment.predicted_tre_p95_mm}})
    if (json.has(key))
      for (const auto& [name, value] : json.at(key).members()) (*map)[name] = atLeastZero(value);
  if (json.has("face_scale")) alignment.face_scale = atLeastZero(json.at("face_scale"));
  if (json.has("face_scale_sigma")) alignment.face_scale_sigma = atLeastZero(json.at("face_scale_sigma"));
  if (json.has("cautions"))
    for (const auto& words : json.at("cautions").elements()) alignment.cautions.push_back(words.text());
  return alignment;
}

}  // namespace facenav::casefile
