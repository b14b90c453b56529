#include <gtest/gtest.h>

#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>
#include <regex>

#include "facenav/coil_tracking/marker_page.h"
#include "facenav/core/error.h"

namespace facenav::coil_tracking {
namespace {

/// Paints the page's rectangles at 8 pixels per millimetre.
cv::Mat painted(const std::string& svg) {
  const double scale = 8;
  cv::Mat page(int(297 * scale), int(210 * scale), CV_8U, cv::Scalar(128));
  const std::regex form(
      "<rect x=\"([^\"]+)\" y=\"([^\"]+)\" width=\"([^\"]+)\" height=\"([^\"]+)\" fill=\"rgb\\((\\d+)");
  for (std::sregex_iterator found(svg.begin(), svg.end(), form), end; found != end; ++found) {
    const auto value = [&](int i) { return std::stod((*found)[i]) * scale; };
    const cv::Point low(int(std::lround(value(1))), int(std::lround(value(2))));
    const cv::Point high(int(std::lround(value(1) + value(3))), int(std::lround(value(2) + value(4))));
    page(cv::Rect(low, high)).setTo(std::stoi((*found)[5]));
  }
  return page;
}

// OpenCV's own detector reads the page: correct id, upright, at true size.
TEST(MarkerPage, IsReadByAnotherDetectorAtTrueSize) {
  CoilModel coil = defaultCoil();
  coil.markers.push_back({"4x4_50", 31, {}, 45.0, 0.1, {}});
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(painted(markerPageSvg(coil)),
                           cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50), corners, ids);
  ASSERT_EQ(ids.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const double size_mm = ids[i] == 7 ? 60.0 : 45.0;
    EXPECT_TRUE(ids[i] == 7 || ids[i] == 31);
    EXPECT_NEAR(cv::norm(corners[i][1] - corners[i][0]) / 8, size_mm, 0.3);
    EXPECT_GT(corners[i][1].x, corners[i][0].x + 100);  // its top left is left of its top right
    EXPECT_GT(corners[i][3].y, corners[i][0].y + 100);
  }
}

TEST(MarkerPage, RefusesWhatDoesNotFit) {
  CoilModel coil = defaultCoil();
  coil.markers[0].size_mm = 180;
  EXPECT_THROW(markerPageSvg(coil), Error);
}

}  // namespace
}  // namespace facenav::coil_tracking
