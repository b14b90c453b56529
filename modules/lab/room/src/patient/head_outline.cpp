#include "head_outline.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace facenav::room {
namespace {

constexpr int kColumns = 72, kRows = 36, kHeights = 50;
constexpr double kLowest_mm = -150.0, kHeight_mm = 5.0;

int columnOf(double azimuth) {
  const int column = int(std::floor((azimuth + M_PI) / (2 * M_PI) * kColumns));
  return (column % kColumns + kColumns) % kColumns;
}

/// Closes gaps and smooths, around the head without a seam.
void smooth(cv::Mat& map) {
  cv::Mat wide;
  cv::copyMakeBorder(map, wide, 4, 4, 8, 8, cv::BORDER_WRAP | cv::BORDER_ISOLATED);
  for (int row = 0; row < 4; ++row) {  // up and down it ends
    wide.row(4).copyTo(wide.row(row));
    wide.row(wide.rows - 5).copyTo(wide.row(wide.rows - 1 - row));
  }
  cv::dilate(wide, wide, cv::Mat::ones(3, 3, CV_8U));
  cv::GaussianBlur(wide, wide, {}, 1.0);
  wide(cv::Rect(8, 4, map.cols, map.rows)).copyTo(map);
}

}  // namespace

HeadOutline::HeadOutline(const VirtualPatient& patient)
    : centre_mm_(patient.head_centre.mm),
      reach_mm_(kRows, kColumns, CV_32F, cv::Scalar(0)),
      width_mm_(kHeights, kColumns, CV_32F, cv::Scalar(0)) {
  for (const auto& p_mm : patient.visible.vertices_mm) {
    const Eigen::Vector3d from = p_mm - centre_mm_;
    const int column = columnOf(std::atan2(from.x(), from.y()));
    const double elevation = std::asin(std::clamp(from.z() / from.norm(), -1.0, 1.0));
    const int row = std::clamp(int((elevation / M_PI + 0.5) * kRows), 0, kRows - 1);
    float& reach = reach_mm_.at<float>(row, column);
    reach = std::max(reach, float(from.norm()));
    const int height = int(std::floor((from.z() - kLowest_mm) / kHeight_mm));
    if (height < 0 || height >= kHeights) continue;
    float& width = width_mm_.at<float>(height, column);
    width = std::max(width, float(from.head<2>().norm()));
  }
  smooth(reach_mm_);
  smooth(width_mm_);
}

double HeadOutline::reach_mm(double azimuth, double elevation) const {
  const double y = std::clamp((elevation / M_PI + 0.5) * kRows - 0.5, 0.0, kRows - 1.001);
  const double x = (azimuth + M_PI) / (2 * M_PI) * kColumns - 0.5;
  const int row = int(y), left = int(std::floor(x));
  const double fy = y - row, fx = x - left;
  const auto value = [&](int r, int c) {
    return double(reach_mm_.at<float>(r, (c % kColumns + kColumns) % kColumns));
  };
  return (1 - fy) * ((1 - fx) * value(row, left) + fx * value(row, left + 1)) +
         fy * ((1 - fx) * value(row + 1, left) + fx * value(row + 1, left + 1));
}

Eigen::Vector3d HeadOutline::at(double azimuth, double elevation, double off_mm) const {
  const Eigen::Vector3d out(std::cos(elevation) * std::sin(azimuth), std::cos(elevation) * std::cos(azimuth),
                            std::sin(elevation));
  return centre_mm_ + (reach_mm(azimuth, elevation) + off_mm) * out;
}

double HeadOutline::width_mm(double azimuth, double up_mm) const {
  const int row = std::clamp(int(std::floor((up_mm - kLowest_mm) / kHeight_mm)), 0, kHeights - 1);
  return double(width_mm_.at<float>(row, columnOf(azimuth)));
}

}  // namespace facenav::room
