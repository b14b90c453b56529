#include "json_pose.h"
#include "readers.h"
#include "text.h"

// StimGuide (Horizon): JSON in metres, in the frame of the last landmarks. How the axes of its coil lie is
// not documented, so only places are taken; the rotation is shown as the file gives it.

namespace facenav::interop {
namespace {

constexpr double kMmPerMetre = 1000;

Eigen::Vector3d placeOf(const JsonReader& json) {
  return kMmPerMetre * Eigen::Vector3d(json.at("X").number(), json.at("Y").number(), json.at("Z").number());
}

std::string rotationOf(const JsonReader& json) {
  std::string words;
  for (const char* key : {"X", "Y", "Z", "W"})
    words += (words.empty() ? "" : " ") + formatted("%.6f", json.at(key).number());
  return words;
}

Item itemOf(const JsonReader& json, Kind kind) {
  Item item;
  item.kind = kind;
  item.name = textOr(json, "Name");
  if (isGiven(json, "Position")) item.place_mm = placeOf(json.at("Position"));
  if (isGiven(json, "Rotation")) item.values["Rotation x y z w"] = rotationOf(json.at("Rotation"));
  item.reason = item.place_mm ? kPlaceOnly : "the file has no position for it";
  if (isGiven(json, "Intensity") && isGiven(json.at("Intensity"), "Value"))
    item.intensity_pct = json.at("Intensity").at("Value").number();
  setTime(textOr(json, "Time"), item);
  if (isGiven(json, "Target")) item.target = textOr(json.at("Target"), "Name");
  return item;
}

HeadPoints pointsOf(const JsonReader& list) {
  const auto all = list.elements();
  if (all.empty()) list.refuse("is empty: its places have no frame");
  const auto& last = all.back();
  return {placeOf(last.at("LeftEar")), placeOf(last.at("Nasion")), placeOf(last.at("RightEar"))};
}

}  // namespace

bool isStimguide(const std::string& content) { return isJsonWith(content, {"Stimuli", "Landmarks"}); }

OtherFile readStimguide(const Source& source) {
  const auto json = jsonOf(source, "Targets");
  OtherFile file;
  file.words = "StimGuide";
  file.space_words = "nasion and ears";
  file.head_points = pointsOf(json.at("Landmarks"));
  file.is_clock_utc = true;
  addItems(json, {{"Targets", Kind::landmark}, {"Stimuli", Kind::pulse}}, itemOf, file);
  return file;
}

}  // namespace facenav::interop
