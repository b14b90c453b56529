#pragma once
// Which prints of one ArUco dictionary a picture shows, whatever coil they belong to: to say that another
// coil than the chosen one is held. For a look now and then: it searches the whole picture.

#include <opencv2/core.hpp>
#include <set>
#include <string>

namespace facenav::coil_tracking {

/// The numbers that are seen. `grey`: 8-bit, 1 channel. Throws Error for an unknown dictionary.
std::set<int> visibleMarkers(const cv::Mat& grey, const std::string& dictionary);

}  // namespace facenav::coil_tracking
