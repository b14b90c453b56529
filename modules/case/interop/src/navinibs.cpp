#include "facenav/core/number_text.h"
#include "facenav/interop/axes.h"
#include "json_pose.h"
#include "readers.h"
#include "text.h"

// NaviNIBS: targets and samples as JSON, RAS mm. A key that NaviNIBS does not know stops it, so only known
// ones are written.

namespace facenav::interop {
namespace {

using Json = nlohmann::ordered_json;

std::optional<Eigen::Vector3d> threeOf(const JsonReader& json, const char* key) {
  if (!isGiven(json, key)) return std::nullopt;
  const auto numbers = json.at(key).numbers(3);
  return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
}

Json threeJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Item itemOf(const JsonReader& json, Kind kind) {
  Item item;
  item.kind = kind;
  item.name = json.at("key").text();
  if (isGiven(json, "coilToMRITransf"))
    item.pose = toFaceNav(nestedPose(json.at("coilToMRITransf")), CoilAxes::brainsight);
  else
    item.reason = "the file has no coilToMRITransf for it";
  if (kind == Kind::pulse) {
    item.target = textOr(json, "targetKey");
    item.values["coilKey"] = textOr(json, "coilKey");
    const std::string stamp = textOr(json, "timestamp");
    if (stamp.size() >= 19) {
      item.time = stamp.substr(0, 10) + " " + stamp.substr(11);
      item.clock_s =
          clockOf(stamp.substr(0, 10), stamp.size() > 22 ? stamp.substr(11, 12) : stamp.substr(11, 8));
    }
    return item;
  }
  item.cortex_point_mm = threeOf(json, "targetCoord");
  item.scalp_point_mm = threeOf(json, "entryCoord");
  if (!item.pose && item.cortex_point_mm) {
    item.kind = Kind::landmark;
    item.place_mm = item.cortex_point_mm;
  }
  return item;
}

}  // namespace

bool isNavinibs(const std::string& content) {
  const std::string start = trimmed(content.substr(0, 400));
  const bool is_json = startsWith(start, "{") || startsWith(start, "[");
  return is_json && contains(content, "\"key\"") &&
         (contains(content, "\"coilToMRITransf\"") || contains(content, "\"targetCoord\""));
}

OtherFile readNavinibs(const Source& source) {
  const auto json = jsonOf(source, contains(source.content, "\"timestamp\"") ? "samples" : "targets");
  OtherFile file;
  file.words = "NaviNIBS";
  file.space_words = "RAS";
  const std::pair<const char*, Kind> kLists[] = {{"targets", Kind::target}, {"samples", Kind::pulse}};
  for (const auto& [key, kind] : kLists) {
    if (!isGiven(json, key)) continue;
    int number = 0;
    for (const auto& element : json.at(key).elements()) {
      file.items.push_back(itemOf(element, kind));
      file.items.back().where = formatted("%s[%d]", key, number++);
    }
  }
  return file;
}

Written writeNavinibs(const Order& order) {
  Json targets = Json::array(), samples = Json::array();
  for (const auto& item : order.items) {
    if (item.kind == Kind::landmark || item.kind == Kind::electrode) continue;
    Json json{{"key", item.name}};
    if (item.kind == Kind::pulse && item.clock_s)
      json["timestamp"] = dateOf(*item.clock_s) + "T" + timeOf(*item.clock_s) + "000";
    if (item.mri_T_coil)
      json["coilToMRITransf"] = nestedJson(fromFaceNav(item.mri_T_coil->matrix(), CoilAxes::brainsight));
    if (item.kind == Kind::pulse) {
      if (!item.target.empty()) json["targetKey"] = item.target;
      samples.push_back(json);
      continue;
    }
    if (item.cortex_point_mm) json["targetCoord"] = threeJson(*item.cortex_point_mm);
    if (item.scalp_point_mm) json["entryCoord"] = threeJson(*item.scalp_point_mm);
    targets.push_back(json);
  }
  Written written;
  if (!samples.empty()) {
    written.content = jsonText({{"samples", samples}});
    written.notes.push_back("targets are in another file of NaviNIBS: export without --session");
  } else {
    targetsOf(order);
    written.content = jsonText({{"targets", targets}});
  }
  return written;
}

}  // namespace facenav::interop
