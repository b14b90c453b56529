#pragma once
// JSON of other programs: lists of items, poses, times.

#include <initializer_list>
#include <nlohmann/json.hpp>

#include "facenav/core/json_reader.h"
#include "facenav/core/number_text.h"
#include "facenav/interop/formats.h"

namespace facenav::interop {

/// True if the content begins as a JSON object and holds all these keys.
bool isJsonWith(const std::string& content, std::initializer_list<const char*> keys);
/// Reads the content; a bare list becomes the member `list`. NaN and Infinity, which Python writes, count as
/// null. Throws Error with the place of the fault.
JsonReader jsonOf(const Source& source, const char* list);
/// Adds `itemOf(element, kind)` of every element of the lists that there are; their places are "targets[0]".
template <class ItemOf>
void addItems(const JsonReader& json, std::initializer_list<std::pair<const char*, Kind>> lists,
              ItemOf itemOf, OtherFile& file);

/// 4 x 4 as nested lists; null stands for no number. Throws Error naming the key.
Eigen::Matrix4d nestedPose(const JsonReader& json);
nlohmann::ordered_json nestedJson(const Eigen::Matrix4d& pose);
/// Pose from a place and the nine numbers of a rotation, row by row.
Eigen::Matrix4d poseOfPlace(const std::vector<double>& place, const std::vector<double>& rotation);
/// Three numbers of a member; nothing if it is absent.
std::optional<Eigen::Vector3d> threeOf(const JsonReader& json, const char* key);
nlohmann::ordered_json threeJson(const Eigen::Vector3d& v);
/// Text of a JSON file, indented by one blank.
std::string jsonText(const nlohmann::ordered_json& json);
/// The text of a member that may be absent.
std::string textOr(const JsonReader& json, const char* key, const std::string& otherwise = {});
/// True if the member exists and is not null.
bool isGiven(const JsonReader& json, const char* key);

template <class ItemOf>
void addItems(const JsonReader& json, std::initializer_list<std::pair<const char*, Kind>> lists,
              ItemOf itemOf, OtherFile& file) {
  for (const auto& [key, kind] : lists) {
    if (!isGiven(json, key)) continue;
    int number = 0;
    for (const auto& element : json.at(key).elements()) {
      file.items.push_back(itemOf(element, kind));
      file.items.back().where = formatted("%s[%d]", key, number++);
    }
  }
}

}  // namespace facenav::interop
