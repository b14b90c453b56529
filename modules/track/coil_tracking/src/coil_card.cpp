#include "facenav/coil_tracking/coil_card.h"

#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/core/json_reader.h"
#include "facenav/core/whole_file.h"
#include "marker_pattern.h"

namespace facenav::coil_tracking {
namespace {

constexpr double kFarthestFocus_mm = 200;

CalibrationRecord readCalibration(const JsonReader& json) {
  CalibrationRecord record;
  record.method = json.at("method").text();
  if (json.has("utc")) record.utc = json.at("utc").text();
  record.rms_mm = json.at("rms_mm").number();
  record.sigma_mm = json.at("sigma_mm").number();
  record.sigma_deg = json.at("sigma_deg").number();
  record.frames = json.at("frames").integer();
  return record;
}

/// Compares what is printed, in any of its four rotations: dictionaries of one size share their first ids.
bool isSamePrint(const MarkerModel& a, const MarkerModel& b) {
  if (a.pattern.has_value() != b.pattern.has_value()) return false;
  if (!a.pattern && a.dictionary == b.dictionary) return a.id == b.id;
  if (a.pattern) return readWholeFile(*a.pattern) == readWholeFile(*b.pattern);
  const cv::Mat cells_a = MarkerPattern::load(a).cells();
  cv::Mat cells_b = MarkerPattern::load(b).cells();
  if (cells_a.size() != cells_b.size()) return false;
  for (int turn = 0; turn < 4; ++turn) {
    if (cv::norm(cells_a, cells_b, cv::NORM_INF) == 0) return true;
    cv::rotate(cells_b.clone(), cells_b, cv::ROTATE_90_CLOCKWISE);
  }
  return false;
}

}  // namespace

CoilCard readCoilCard(const std::filesystem::path& coil_json) {
  const JsonReader json = JsonReader::readFile(coil_json);
  CoilCard card;
  if (json.has("name")) card.name = json.at("name").text();
  if (json.has("make")) card.make = json.at("make").text();
  if (json.has("model")) card.model = json.at("model").text();
  if (json.has("serial")) card.serial = json.at("serial").text();
  if (json.has("focus_mm")) {
    const auto focus = json.at("focus_mm").numbers(3);
    card.focus_mm = {focus[0], focus[1], focus[2]};
    if (card.focus_mm.norm() > kFarthestFocus_mm)
      json.at("focus_mm").refuse("a place within 200 mm of the coil's centre was expected");
  }
  card.has_outline = json.has("contact_outline_mm");
  if (json.has("calibration")) card.calibration = readCalibration(json.at("calibration"));
  return card;
}

std::string markerWords(const MarkerModel& marker) {
  if (marker.pattern) return "pattern " + marker.pattern->filename().string();
  return marker.dictionary + " id " + std::to_string(marker.id);
}

bool shareMarker(const CoilModel& a, const CoilModel& b) {
  return std::any_of(a.markers.begin(), a.markers.end(), [&](const MarkerModel& of_a) {
    return std::any_of(b.markers.begin(), b.markers.end(),
                       [&](const MarkerModel& of_b) { return isSamePrint(of_a, of_b); });
  });
}

void requireOwnMarker(const CoilModel& a, const CoilModel& b) {
  if (shareMarker(a, b))
    throw Error("the coil '" + a.name + "' carries the same marker as '" + b.name + "' (" +
                    markerWords(a.markers.front()) + "): a picture cannot tell them apart",
                {}, "print another marker for one of them");
}

void requireTellable(const CoilModel& a, const CoilModel& b) {
  requireOwnMarker(a, b);
  if (a.name.empty() || a.name == b.name)
    throw Error("two coils need two names, not '" + a.name + "' and '" + b.name + "'", {},
                "give one another name in its coil.json");
}

}  // namespace facenav::coil_tracking
