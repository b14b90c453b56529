#include "facenav/evaluation/cross_section.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace facenav::evaluation {
namespace {

cv::Mat greyPicture(const volume::Volume& mri, const volume::SlicePlane& plane) {
  const auto values = volume::sampleSlice(mri, plane);
  const float white = std::max(1e-6f, volume::percentile(mri, 0.995));
  cv::Mat grey(plane.height, plane.width, CV_8UC1);
  std::transform(values.begin(), values.end(), grey.begin<std::uint8_t>(),
                 [white](float v) { return std::uint8_t(std::clamp(255.f * v / white, 0.f, 255.f)); });
  cv::Mat colour;
  cv::cvtColor(grey, colour, cv::COLOR_GRAY2BGR);
  return colour;
}

void drawSides(cv::Mat& picture, volume::Anatomical orientation) {
  const bool is_sagittal = orientation == volume::Anatomical::sagittal;
  const cv::Scalar white(230, 230, 230);
  cv::putText(picture, is_sagittal ? "A" : "R", {8, picture.rows / 2}, cv::FONT_HERSHEY_DUPLEX, 0.8, white, 1,
              cv::LINE_AA);
  cv::putText(picture, is_sagittal ? "P" : "L", {picture.cols - 26, picture.rows / 2},
              cv::FONT_HERSHEY_DUPLEX, 0.8, white, 1, cv::LINE_AA);
}

}  // namespace

cv::Mat drawCrossSection(const volume::Volume& mri, volume::Anatomical orientation, const Point<Mri>& through,
                         const PointCloud<Mri>& cloud_mri, const CrossSectionOptions& options) {
  const auto plane = volume::anatomicalPlane(mri.grid, orientation, through, 1.0 / options.scale);
  cv::Mat picture = greyPicture(mri, plane);
  for (const auto& p_mri_mm : cloud_mri.points_mm) {
    const Eigen::Vector3d uvd = plane.toPixel(Point<Mri>(p_mri_mm));
    if (std::abs(uvd[2]) > options.thickness_mm) continue;
    cv::circle(picture, {int(std::lround(uvd[0])), int(std::lround(uvd[1]))}, 1, {40, 40, 255}, cv::FILLED,
               cv::LINE_AA);
  }
  drawSides(picture, orientation);
  return picture;
}

}  // namespace facenav::evaluation
