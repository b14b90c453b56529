#include "facenav/cameras/marker_dictionary.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <opencv2/aruco.hpp>

#include "facenav/core/error.h"

namespace facenav::cameras {
namespace {

const std::map<std::string, int>& dictionaries() {
  static const std::map<std::string, int> names = [] {
    std::map<std::string, int> map{{"aruco_original", cv::aruco::DICT_ARUCO_ORIGINAL},
                                   {"apriltag_16h5", cv::aruco::DICT_APRILTAG_16h5},
                                   {"apriltag_25h9", cv::aruco::DICT_APRILTAG_25h9},
                                   {"apriltag_36h10", cv::aruco::DICT_APRILTAG_36h10},
                                   {"apriltag_36h11", cv::aruco::DICT_APRILTAG_36h11}};
    int number = cv::aruco::DICT_4X4_50;  // OpenCV numbers them 4x4 .. 7x7, 50 .. 1000, in this order
    for (const char* grid : {"4x4", "5x5", "6x6", "7x7"})
      for (const char* count : {"50", "100", "250", "1000"}) map[std::string(grid) + "_" + count] = number++;
    return map;
  }();
  return names;
}

std::string plainName(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return name.rfind("dict_", 0) == 0 ? name.substr(5) : name;
}

}  // namespace

int predefinedDictionary(const std::string& name) {
  const auto found = dictionaries().find(plainName(name));
  if (found != dictionaries().end()) return found->second;
  std::string known;
  for (const auto& entry : dictionaries()) known += (known.empty() ? "" : ", ") + entry.first;
  throw Error("unknown marker dictionary '" + name + "'", {}, "choose one of: " + known);
}

}  // namespace facenav::cameras
