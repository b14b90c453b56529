#pragma once
// Poses in JSON of other programs: four lists of four numbers.

#include <nlohmann/json.hpp>

#include "facenav/core/json_reader.h"
#include "facenav/interop/formats.h"

namespace facenav::interop {

/// Reads the content; a bare list becomes the member `list`. Throws Error with the place of the fault.
JsonReader jsonOf(const Source& source, const char* list);
/// 4 x 4 as nested lists. Throws Error naming the key.
Eigen::Matrix4d nestedPose(const JsonReader& json);
nlohmann::ordered_json nestedJson(const Eigen::Matrix4d& pose);
/// Text of a JSON file, indented by one blank.
std::string jsonText(const nlohmann::ordered_json& json);
/// The text of a member that may be absent.
std::string textOr(const JsonReader& json, const char* key, const std::string& otherwise = {});
/// True if the member exists and is not null.
bool isGiven(const JsonReader& json, const char* key);

}  // namespace facenav::interop
