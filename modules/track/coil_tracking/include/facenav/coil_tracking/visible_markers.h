#pragma once
// Finds the markers of one ArUco dictionary in a picture, of any coil, to detect that another coil than the
// chosen one is used. It searches the whole picture, so it is too slow for every frame.

#include <opencv2/core.hpp>
#include <set>
#include <string>

namespace facenav::coil_tracking {

/// Returns the ids of the visible markers. `grey`: 8-bit, 1 channel. Throws Error for an unknown dictionary.
std::set<int> visibleMarkers(const cv::Mat& grey, const std::string& dictionary);

}  // namespace facenav::coil_tracking
