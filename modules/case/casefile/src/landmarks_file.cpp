#include "facenav/casefile/landmarks_file.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "facenav/core/error.h"
#include "facenav/core/json_reader.h"
#include "facenav/core/whole_file.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

fs::path landmarksFile(const fs::path& case_folder) { return case_folder / "landmarks.json"; }
double thousandth(double value_mm) { return std::round(1000 * value_mm) / 1000; }

surface::ScalpLandmark readLandmark(const JsonReader& json) {
  const auto mm = json.at("mm").numbers(3);
  surface::ScalpLandmark landmark;
  landmark.point = Point<Mri>(mm[0], mm[1], mm[2]);
  landmark.sd_mm = json.at("sd_mm").number();
  if (landmark.sd_mm < 0) json.at("sd_mm").refuse("a standard error is not negative");
  try {
    landmark.source = surface::landmarkSourceFrom(json.at("source").text());
  } catch (const Error& fault) {
    json.at("source").refuse(fault.what());
  }
  landmark.is_cut = json.has("on_scan_edge");
  if (json.has("utc")) landmark.utc = json.at("utc").text();
  if (json.has("by")) landmark.by = json.at("by").text();
  return landmark;
}

}  // namespace

void writeLandmarks(const surface::ScalpLandmarks& landmarks, const fs::path& case_folder) {
  Json list = Json::array();
  for (const surface::Landmark which : surface::kLandmarks) {
    const auto& landmark = landmarks[which];
    if (!landmark) continue;
    const Eigen::Vector3d& p = landmark->point.mm;
    list.push_back({{"name", toString(which)},
                    {"mm", {thousandth(p.x()), thousandth(p.y()), thousandth(p.z())}},
                    {"sd_mm", thousandth(landmark->sd_mm)},
                    {"source", toString(landmark->source)}});
    if (landmark->is_cut) list.back()["on_scan_edge"] = true;
    if (!landmark->utc.empty()) list.back()["utc"] = landmark->utc;
    if (!landmark->by.empty()) list.back()["by"] = landmark->by;
  }
  const Json json{{"landmarks", list}};
  writeWholeFile(landmarksFile(case_folder), json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n",
                 FileAccess::owner_only);
}

std::optional<surface::ScalpLandmarks> readLandmarks(const fs::path& case_folder) {
  if (!fs::exists(landmarksFile(case_folder))) return std::nullopt;
  surface::ScalpLandmarks landmarks;
  for (const JsonReader& json : JsonReader::readFile(landmarksFile(case_folder)).at("landmarks").elements()) {
    const std::string name = json.at("name").text();
    for (const surface::Landmark which : surface::kLandmarks)
      if (toString(which) == name) landmarks[which] = readLandmark(json);  // other tools may add names
  }
  return landmarks;
}

}  // namespace facenav::casefile
