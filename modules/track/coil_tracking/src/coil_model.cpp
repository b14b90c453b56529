#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/core/whole_file.h"
#include "facenav/geometry/json_transform.h"
#include "marker_pattern.h"

namespace facenav::coil_tracking {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

double readSize_mm(const JsonReader& json) {
  const double size_mm = json.number();
  if (size_mm < 5.0 || size_mm > 1000.0)
    json.refuse("the edge of the black square in millimetres (5 to 1000) was expected");
  return size_mm;
}

/// Loads the pattern once, so that an unknown dictionary or id, or a broken .patt, is reported with file and
/// key.
void requireLoadable(const MarkerModel& marker, const JsonReader& json) {
  try {
    MarkerPattern::load(marker);
  } catch (const Error& fault) {
    json.refuse(fault.what());
  }
}

MarkerModel readMarker(const JsonReader& json, const fs::path& folder) {
  MarkerModel marker;
  if (json.has("pattern")) {
    marker.pattern = folder / json.at("pattern").text();
  } else {
    marker.dictionary = json.at("dictionary").text();
    marker.id = json.at("id").integer();
  }
  marker.size_mm = readSize_mm(json.at("size_mm"));
  if (json.has("size_sigma_mm")) {
    marker.size_sigma_mm = json.at("size_sigma_mm").number();
    if (!(marker.size_sigma_mm > 0 && marker.size_sigma_mm < marker.size_mm))
      json.at("size_sigma_mm").refuse("how well the size is known, in millimetres, was expected (above 0)");
  }
  requireLoadable(marker, json);
  return marker;
}

std::vector<MarkerModel> readMarkers(const JsonReader& json, const fs::path& folder) {
  std::vector<MarkerModel> markers;
  if (json.has("markers")) {
    for (const JsonReader& element : json.at("markers").elements()) {
      markers.push_back(readMarker(element, folder));
      markers.back().coil_T_marker = readTransform<Coil, Marker>(element.at("coil_T_marker"));
    }
    if (markers.empty()) json.at("markers").refuse("at least one marker was expected");
  } else {
    markers.push_back(readMarker(json.at("marker"), folder));
    markers.back().coil_T_marker = readTransform<Marker, Coil>(json.at("marker_T_coil")).inverse();
  }
  return markers;
}

void requireDifferent(const std::vector<MarkerModel>& markers, const JsonReader& json) {
  std::set<std::pair<std::string, int>> seen;
  for (const MarkerModel& marker : markers) {
    const auto key = marker.pattern ? std::make_pair(marker.pattern->string(), -1)
                                    : std::make_pair(marker.dictionary, marker.id);
    if (!seen.insert(key).second)
      json.refuse("the same marker is given twice, so the one that is seen cannot be identified");
  }
}

constexpr double kFarthestTip_mm = 500.0;

Point<Coil> readTip(const JsonReader& json) {
  const auto numbers = json.numbers(3);
  const Point<Coil> tip(numbers[0], numbers[1], numbers[2]);
  if (!(tip.mm.norm() <= kFarthestTip_mm))
    json.refuse("a tip at most 500 mm from the coil's centre was expected");
  return tip;
}

Json toJson(const MarkerModel& marker, const fs::path& folder) {
  Json json;
  if (marker.pattern) {
    const fs::path relative = fs::absolute(*marker.pattern).lexically_relative(fs::absolute(folder));
    json["pattern"] = relative.empty() ? marker.pattern->string() : relative.string();
  } else {
    json["dictionary"] = marker.dictionary;
    json["id"] = marker.id;
  }
  json["size_mm"] = marker.size_mm;
  if (marker.size_sigma_mm != MarkerModel{}.size_sigma_mm) json["size_sigma_mm"] = marker.size_sigma_mm;
  return json;
}

fs::path folderOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

}  // namespace

CoilModel readCoil(const fs::path& path) {
  const JsonReader json = JsonReader::readFile(path);
  CoilModel coil;
  if (json.has("name")) coil.name = json.at("name").text();
  coil.markers = readMarkers(json, folderOf(path));
  requireDifferent(coil.markers, json);
  if (json.has("mesh")) coil.mesh = folderOf(path) / json.at("mesh").text();
  if (json.has("tip_mm")) coil.tip = readTip(json.at("tip_mm"));
  return coil;
}

void writeCoil(const CoilModel& coil, const fs::path& path) {
  FACENAV_EXPECT(!coil.markers.empty(), "a coil needs a marker");
  const fs::path folder = folderOf(path);
  Json json;
  json["name"] = coil.name;
  if (coil.markers.size() == 1) {
    json["marker"] = toJson(coil.markers.front(), folder);
    json["marker_T_coil"] = rowMajor(coil.marker_T_coil());
  } else {
    for (const MarkerModel& marker : coil.markers) {
      json["markers"].push_back(toJson(marker, folder));
      json["markers"].back()["coil_T_marker"] = rowMajor(marker.coil_T_marker);
    }
  }
  if (coil.mesh) {
    const fs::path relative = fs::absolute(*coil.mesh).lexically_relative(fs::absolute(folder));
    json["mesh"] = relative.empty() ? coil.mesh->string() : relative.string();
  }
  if (!coil.tip.mm.isZero()) json["tip_mm"] = {coil.tip.mm.x(), coil.tip.mm.y(), coil.tip.mm.z()};
  writeWholeFile(path, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n", FileAccess::by_umask);
}

CoilModel defaultCoil() {
  CoilModel coil;
  coil.name = "one 60 mm marker";
  coil.markers = {MarkerModel{}};
  return coil;
}

}  // namespace facenav::coil_tracking
