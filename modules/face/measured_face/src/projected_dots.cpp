#include "facenav/measured_face/projected_dots.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "facenav/core/robust_statistics.h"

namespace facenav::measured_face {
namespace {

constexpr int kFineScale_px = 9;
constexpr double kDotsContrast = 1.5;  // least ratio of fine detail with dots to that without dots

// Dense dots lie 4 to 8 px apart at 640 px. The paper's lie ten times as far apart, so that hardly any tile
// with a dot has a neighbour with one.
constexpr int kTilesAcross = 40, kFewestDots = 12;
constexpr double kDense = 0.4, kDark_grey = 8.0, kDotOverSkin = 0.25;

/// One value per tile: 1 if a point is clearly brighter than the tile's middle.
cv::Mat brightPoints(const cv::Mat& image, int tile_px) {
  cv::Mat found = cv::Mat::zeros(image.rows / tile_px, image.cols / tile_px, CV_8U);
  std::vector<double> grey;
  for (int row = 0; row < found.rows; ++row)
    for (int column = 0; column < found.cols; ++column) {
      grey.clear();
      for (int y = row * tile_px; y < (row + 1) * tile_px; ++y)
        grey.insert(grey.end(), image.ptr(y) + column * tile_px, image.ptr(y) + (column + 1) * tile_px);
      const double most = *std::max_element(grey.begin(), grey.end()), middle = upperMedian(grey);
      found.at<unsigned char>(row, column) = middle > kDark_grey && most > (1.0 + kDotOverSkin) * middle;
    }
  return found;
}

/// Fine detail relative to the mean grey level.
double fineContrast(const cv::Mat& image) {
  cv::Mat grey, smooth;
  image.convertTo(grey, CV_32F);
  cv::boxFilter(grey, smooth, -1, {kFineScale_px, kFineScale_px});
  return cv::norm(grey - smooth, cv::NORM_L2) / std::max(1.0, cv::norm(grey, cv::NORM_L2));
}

}  // namespace

bool showsDots(const capture::CapturePair& capture) {
  return fineContrast(capture.pattern.left) > kDotsContrast * fineContrast(capture.plain.left);
}

bool areDotsSparse(const capture::CapturePair& capture) {
  const int tile_px = std::max(8, capture.pattern.left.cols / kTilesAcross);
  if (capture.pattern.left.type() != CV_8U || capture.plain.left.size() != capture.pattern.left.size())
    return false;
  const cv::Mat dots = brightPoints(capture.pattern.left, tile_px),
                own = brightPoints(capture.plain.left,
                                   tile_px);  // ignores what the plain image shows too
  int single = 0, beside = 0;
  for (int row = 0; row < dots.rows; ++row)
    for (int column = 0; column + 1 < dots.cols; ++column) {
      if (own.at<unsigned char>(row, column) || own.at<unsigned char>(row, column + 1)) continue;
      const int both = dots.at<unsigned char>(row, column) + dots.at<unsigned char>(row, column + 1);
      single += both == 1, beside += both == 2;
    }
  return single + beside > kFewestDots && beside < kDense * (single + beside);
}

}  // namespace facenav::measured_face
