#include "json_pose.h"

#include <algorithm>
#include <cmath>

#include "text.h"

namespace facenav::interop {
namespace {

/// The text with null in place of NaN and Infinity outside of quotes.
std::string withoutNan(const std::string& text) {
  std::string result;
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (is_quoted && text[i] == '\\' && i + 1 < text.size()) {
      result += text[i];
      result += text[++i];
      continue;
    }
    if (text[i] == '"') is_quoted = !is_quoted;
    std::size_t length = 0;
    if (!is_quoted)
      for (const char* word : {"NaN", "-Infinity", "Infinity"})
        if (length == 0 && text.compare(i, std::string(word).size(), word) == 0)
          length = std::string(word).size();
    result += length > 0 ? std::string("null") : std::string(1, text[i]);
    if (length > 0) i += length - 1;
  }
  return result;
}

}  // namespace

bool isJsonWith(const std::string& content, std::initializer_list<const char*> keys) {
  const auto holds = [&](const char* key) { return contains(content, '"' + std::string(key) + '"'); };
  return startsWith(trimmed(content.substr(0, 400)), "{") && std::all_of(keys.begin(), keys.end(), holds);
}

JsonReader jsonOf(const Source& source, const char* list) {
  const auto first = source.content.find_first_not_of(" \t\r\n");
  const bool is_list = first != std::string::npos && source.content[first] == '[';
  const bool has_nan = contains(source.content, "NaN") || contains(source.content, "Infinity");
  const std::string text = has_nan ? withoutNan(source.content) : source.content;
  return JsonReader::readText(is_list ? "{\"" + std::string(list) + "\":" + text + "}" : text, source.path);
}

Eigen::Matrix4d nestedPose(const JsonReader& json) {
  const auto rows = json.elements();
  if (rows.size() != 4) json.refuse("is no list of four rows");
  Eigen::Matrix4d pose;
  for (int row = 0; row < 4; ++row) {
    const auto numbers = rows[std::size_t(row)].elements();
    if (numbers.size() != 4) json.refuse("has a row that is no list of four numbers");
    for (int column = 0; column < 4; ++column) {
      const auto& number = numbers[std::size_t(column)];
      pose(row, column) = number.isNull() ? std::nan("") : number.number();
    }
  }
  return pose;
}

nlohmann::ordered_json nestedJson(const Eigen::Matrix4d& pose) {
  auto rows = nlohmann::ordered_json::array();
  for (int row = 0; row < 4; ++row)
    rows.push_back({pose(row, 0) + 0.0, pose(row, 1) + 0.0, pose(row, 2) + 0.0, pose(row, 3) + 0.0});
  return rows;
}

Eigen::Matrix4d poseOfPlace(const std::vector<double>& place, const std::vector<double>& rotation) {
  Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
  for (int row = 0; row < 3; ++row) {
    pose(row, 3) = place[std::size_t(row)];
    for (int column = 0; column < 3; ++column) pose(row, column) = rotation[std::size_t(3 * row + column)];
  }
  return pose;
}

std::optional<Eigen::Vector3d> threeOf(const JsonReader& json, const char* key) {
  if (!isGiven(json, key)) return std::nullopt;
  const auto numbers = json.at(key).numbers(3);
  return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
}

nlohmann::ordered_json threeJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

std::string jsonText(const nlohmann::ordered_json& json) {
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string textOr(const JsonReader& json, const char* key, const std::string& otherwise) {
  return isGiven(json, key) ? json.at(key).text() : otherwise;
}

bool isGiven(const JsonReader& json, const char* key) { return json.has(key) && !json.at(key).isNull(); }

}  // namespace facenav::interop
