#include "facenav/coil_tracking/visible_markers.h"

#include <opencv2/aruco.hpp>
#include <vector>

#include "facenav/cameras/marker_dictionary.h"

namespace facenav::coil_tracking {

std::set<int> visibleMarkers(const cv::Mat& grey, const std::string& dictionary) {
  const auto prints = cv::aruco::getPredefinedDictionary(cameras::predefinedDictionary(dictionary));
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  if (!grey.empty()) cv::aruco::detectMarkers(grey, prints, corners, ids);
  return {ids.begin(), ids.end()};
}

}  // namespace facenav::coil_tracking
