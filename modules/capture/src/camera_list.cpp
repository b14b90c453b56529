#include "facenav/capture/camera_list.h"

#include <algorithm>
#include <fstream>

namespace facenav::capture {
namespace {

std::string firstLine(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

}  // namespace

std::vector<CameraDevice> listCameras(const std::filesystem::path& entries) {
  std::vector<CameraDevice> cameras;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(entries, ignored)) {
    const std::string name = entry.path().filename().string(),
                      digits = name.substr(std::min<std::size_t>(5, name.size()));
    const bool is_video = name.rfind("video", 0) == 0 && !digits.empty() && digits.size() < 5 &&
                          digits.find_first_not_of("0123456789") == std::string::npos;
    if (!is_video || firstLine(entry.path() / "index") != "0") continue;
    const std::string words = firstLine(entry.path() / "name");
    cameras.push_back({std::stoi(digits), words.empty() ? name : words});
  }
  std::sort(cameras.begin(), cameras.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
  return cameras;
}

}  // namespace facenav::capture
