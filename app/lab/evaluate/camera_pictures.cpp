#include "evaluate/camera_pictures.h"

#include <opencv2/imgcodecs.hpp>

#include "facenav/core/error.h"

namespace facenav::app {
namespace fs = std::filesystem;

std::map<std::string, fs::path> picturesIn(const fs::path& folder) {
  std::map<std::string, fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().stem().string(), type = entry.path().extension().string();
    if (name.size() > 2 && name[1] == '_' && (type == ".jpg" || type == ".png")) files[name] = entry.path();
  }
  return files;
}

std::map<std::string, cameras::StereoRig> rigsIn(const fs::path& folder) {
  std::map<std::string, cameras::StereoRig> rigs;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.size() == 13 && name.substr(2) == "_stereo.yml")
      rigs[name.substr(0, 2)] = cameras::readRig(entry.path());
  }
  return rigs;
}

std::vector<std::string> momentsOf(const std::map<std::string, fs::path>& pictures, char left, char right) {
  std::vector<std::string> moments;
  for (const auto& [name, path] : pictures)
    if (name[0] == left && pictures.count(right + name.substr(1))) moments.push_back(name.substr(2));
  return moments;
}

cv::Mat readGrey(const fs::path& path) {
  cv::Mat grey = cv::imread(path.string(), cv::IMREAD_GRAYSCALE);
  if (grey.empty()) throw Error("the picture cannot be read", path.string(), "give a JPEG or PNG file");
  return grey;
}

}  // namespace facenav::app
