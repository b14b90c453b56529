#include "facenav/capture/stream_logins.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "configuration_folder.h"
#include "facenav/core/json_reader.h"
#include "facenav/core/number_text.h"
#include "facenav/core/shown_address.h"
#include "facenav/core/whole_file.h"

namespace facenav::capture {
namespace fs = std::filesystem;
namespace {

using Logins = std::map<std::string, std::string>;  // address as shown -> as typed

Logins readLogins(const fs::path& file) {
  Logins logins;
  if (!fs::exists(file)) return logins;
  const JsonReader json = JsonReader::readFile(file);
  for (const auto& [shown, full] : json.members()) logins[shown] = full.text();
  return logins;
}

/// The address with the signs of its password that would end it written as FFmpeg reads them: "%2F" for '/'.
/// The password is what the shown address lacks before its '@'.
std::string withEncodedPassword(const std::string& full, const std::string& shown) {
  std::size_t begin = 0;
  while (begin < std::min(shown.size(), full.size()) && full[begin] == shown[begin]) ++begin;
  if (begin >= shown.size() || shown[begin] != '@') return full;  // a value of the query
  const std::size_t end = full.rfind(shown.substr(begin, shown.find('?', begin) - begin));
  if (end == std::string::npos || end < begin) return full;
  std::string encoded = full.substr(0, begin);
  for (const char c : full.substr(begin, end - begin)) {
    const bool ends_it = std::string("/?#@ ").find(c) != std::string::npos;
    encoded += ends_it ? formatted("%%%02X", int(static_cast<unsigned char>(c))) : std::string(1, c);
  }
  return encoded + full.substr(end);
}

}  // namespace

CameraIdentity streamIdentity(const std::string& typed) {
  CameraIdentity identity{"stream", shownAddress(typed), "", "", ""};
  if (identity.address != typed) identity.full_address = typed;
  return identity;
}

fs::path StreamLogins::file() const {
  if (!given_.empty()) return given_;
  return configurationFolder("set HOME: passwords of cameras are kept there") / "stream_logins.json";
}

void StreamLogins::keep(const CameraIdentity& camera) const {
  if (camera.full_address.empty()) return;
  const fs::path file = this->file();
  Logins logins = readLogins(file);
  if (logins[camera.address] == camera.full_address) return;
  logins[camera.address] = camera.full_address;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  writeWholeFile(file,
                 nlohmann::json(logins).dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n",
                 FileAccess::owner_only);
}

std::string StreamLogins::openingAddress(const CameraIdentity& camera) const {
  if (!camera.full_address.empty()) return withEncodedPassword(camera.full_address, camera.address);
  if (camera.address.find_first_of("@?") == std::string::npos) return camera.address;
  const Logins logins = readLogins(file());
  const auto kept = logins.find(camera.address);
  return kept == logins.end() ? camera.address : withEncodedPassword(kept->second, kept->first);
}

std::string keptApart(const std::string& typed) {
  static const std::string kStableName = "stream:";
  if (typed.rfind(kStableName, 0) == 0) return kStableName + keptApart(typed.substr(kStableName.size()));
  const CameraIdentity stream = streamIdentity(typed);
  if (!stream.full_address.empty()) StreamLogins().keep(stream);
  return stream.address;
}

}  // namespace facenav::capture
