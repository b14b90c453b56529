#include "facenav/interop/axes.h"
#include "json_pose.h"
#include "readers.h"
#include "text.h"

// NaviNIBS: targets and samples as JSON, RAS mm. A key that NaviNIBS does not know stops it, so only known
// ones are written.

namespace facenav::interop {
namespace {

using Json = nlohmann::ordered_json;

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
    setTime(textOr(json, "timestamp"), item);
    return item;
  }
  item.cortex_point_mm = threeOf(json, "targetCoord");
  item.scalp_point_mm = threeOf(json, "entryCoord");
  if (!item.pose && item.cortex_point_mm) {
    item.kind = Kind::landmark;
    item.place_mm = item.cortex_point_mm;
    item.reason = "NaviNIBS computes its pose and did not store it: 'facenav target' plans one at this place";
  }
  return item;
}

OtherFile readLists(const JsonReader& json) {
  OtherFile file;
  file.words = "NaviNIBS";
  file.space_words = "RAS";
  addItems(json, {{"targets", Kind::target}, {"samples", Kind::pulse}}, itemOf, file);
  return file;
}

}  // namespace

bool isNavinibs(const std::string& content) {
  const std::string start = trimmed(content.substr(0, 400));
  const bool is_json = startsWith(start, "{") || startsWith(start, "[");
  return is_json && contains(content, "\"key\"") &&
         (contains(content, "\"coilToMRITransf\"") || contains(content, "\"targetCoord\""));
}

OtherFile readNavinibs(const Source& source) {
  return readNavinibsList(source, contains(source.content, "\"timestamp\"") ? "samples" : "targets");
}

OtherFile readNavinibsList(const Source& source, const char* list) { return readLists(jsonOf(source, list)); }

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
