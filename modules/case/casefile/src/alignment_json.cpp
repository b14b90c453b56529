#include <Eigen/Eigenvalues>
#include <nlohmann/json.hpp>

#include "case_json.h"
#include "facenav/casefile/case_store.h"
#include "facenav/core/whole_file.h"
#include "facenav/geometry/json_transform.h"
#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"

namespace facenav::casefile {
namespace {

double atLeastZero(const JsonReader& json) {
  const double value = json.number();
  if (value < 0) json.refuse("a number >= 0 was expected");
  return value;
}

const char* const kConfirmed = "confirmed";
const char* const kCovariance = "pose_covariance_deg_mm";
const char* const kFreedom = "pose_freedom";

/// Factors for (rotation, translation): files use degrees, the program radians.
Vector6d degreesPerRadian() {
  Vector6d units;
  units << Eigen::Vector3d::Constant(kDegPerRad), Eigen::Vector3d::Ones();
  return units;
}

std::vector<double> asInFile(const Matrix6d& covariance) {
  const Vector6d units = degreesPerRadian();
  const Eigen::Matrix<double, 6, 6, Eigen::RowMajor> in_file =
      units.asDiagonal() * covariance * units.asDiagonal();
  return {in_file.data(), in_file.data() + in_file.size()};
}

Matrix6d readCovariance(const JsonReader& json) {
  const auto values = json.numbers(36);
  const Vector6d units = degreesPerRadian().cwiseInverse();
  const Matrix6d covariance = units.asDiagonal() *
                              Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(values.data()) *
                              units.asDiagonal();
  constexpr double kRounding = 1e-9;  // relative
  const double size = covariance.norm();
  if ((covariance - covariance.transpose()).norm() > kRounding * size)
    json.refuse("a symmetric matrix was expected");
  if (principalAxes(covariance).values(0) < -kRounding * size)
    json.refuse("a covariance has no negative eigenvalue");
  return 0.5 * (covariance + covariance.transpose());
}

std::optional<registration::PoseUncertainty> readUncertainty(const JsonReader& json) {
  if (!json.has(kCovariance)) return std::nullopt;
  registration::PoseUncertainty uncertainty;
  uncertainty.covariance = readCovariance(json.at(kCovariance));
  if (json.has(kFreedom)) uncertainty.freedom = atLeastZero(json.at(kFreedom));
  return uncertainty;
}

}  // namespace

std::optional<double> StoredAlignment::predictedError_mm(const guidance::Target& target) const {
  if (uncertainty) return uncertainty->predictedError_mm(camera_T_mri, target.cortex_point);
  const auto found = predicted_tre_mm.find(target.name);
  return found == predicted_tre_mm.end() ? std::nullopt : std::optional(found->second);
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
  if (alignment.uncertainty) {
    json[kCovariance] = asInFile(alignment.uncertainty->covariance);
    json[kFreedom] = alignment.uncertainty->freedom;
  }
  if (alignment.face_scale) {
    json["face_scale"] = alignment.face_scale->value;
    json["face_scale_sigma"] = alignment.face_scale->sigma;
  }
  if (alignment.face_size_error) json["face_size_error"] = *alignment.face_size_error;
  if (!alignment.cautions.empty()) json["cautions"] = alignment.cautions;
  if (alignment.rests_on_confirmation) json["patient"] = kConfirmed;
  if (alignment.from) json["from"] = *alignment.from;
  if (alignment.matcher) json["matcher"] = *alignment.matcher;
  if (!alignment.settings.empty()) json["settings"] = alignment.settings;
  writeWholeFile(path, json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n",
                 FileAccess::owner_only);
}

StoredAlignment readAlignment(const std::filesystem::path& path) {
  const JsonReader json = JsonReader::readFile(path);
  StoredAlignment alignment;
  alignment.settings = json.has("settings") ? readSettings(json.at("settings")) : SettingValues{};
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
  alignment.uncertainty = readUncertainty(json);
  if (json.has("face_scale") && json.has("face_scale_sigma"))
    alignment.face_scale =
        registration::FaceScale{atLeastZero(json.at("face_scale")), atLeastZero(json.at("face_scale_sigma"))};
  if (json.has("face_size_error")) alignment.face_size_error = atLeastZero(json.at("face_size_error"));
  if (json.has("cautions"))
    for (const auto& words : json.at("cautions").elements()) alignment.cautions.push_back(words.text());
  alignment.rests_on_confirmation = json.has("patient") && json.at("patient").text() == kConfirmed;
  if (json.has("from")) alignment.from = json.at("from").text();
  if (json.has("matcher")) alignment.matcher = json.at("matcher").text();
  return alignment;
}

void setAlignmentAside(const std::filesystem::path& case_folder) {
  namespace fs = std::filesystem;
  for (const auto& [name, aside] : {std::pair{"alignment.json", "alignment_judged_wrong.json"},
                                    {"alignment_capture", "alignment_capture_judged_wrong"}}) {
    if (!fs::exists(case_folder / name)) continue;
    std::error_code fault;
    fs::remove_all(case_folder / aside, fault);
    fs::rename(case_folder / name, case_folder / aside, fault);
    if (fault)
      throw Error("cannot be set aside (" + fault.message() + ")", (case_folder / name).string(),
                  "align again before the next session");
  }
}

}  // namespace facenav::casefile
