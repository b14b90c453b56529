#include "json_pose.h"

#include "text.h"

namespace facenav::interop {

JsonReader jsonOf(const Source& source, const char* list) {
  const auto first = source.content.find_first_not_of(" \t\r\n");
  const bool is_list = first != std::string::npos && source.content[first] == '[';
  if (!is_list) return JsonReader::readText(source.content, source.path);
  return JsonReader::readText("{\"" + std::string(list) + "\":" + source.content + "}", source.path);
}

Eigen::Matrix4d nestedPose(const JsonReader& json) {
  const auto rows = json.elements();
  if (rows.size() != 4) json.refuse("is no list of four rows");
  Eigen::Matrix4d pose;
  for (int row = 0; row < 4; ++row) {
    const auto numbers = rows[std::size_t(row)].numbers(4);
    for (int column = 0; column < 4; ++column) pose(row, column) = numbers[std::size_t(column)];
  }
  return pose;
}

nlohmann::ordered_json nestedJson(const Eigen::Matrix4d& pose) {
  auto rows = nlohmann::ordered_json::array();
  for (int row = 0; row < 4; ++row)
    rows.push_back({pose(row, 0) + 0.0, pose(row, 1) + 0.0, pose(row, 2) + 0.0, pose(row, 3) + 0.0});
  return rows;
}

std::string jsonText(const nlohmann::ordered_json& json) {
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string textOr(const JsonReader& json, const char* key, const std::string& otherwise) {
  return isGiven(json, key) ? json.at(key).text() : otherwise;
}

bool isGiven(const JsonReader& json, const char* key) { return json.has(key) && !json.at(key).isNull(); }

}  // namespace facenav::interop
