#include "facenav/pictures/skin_fit_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "drawn_words.h"
#include "to_rgb.h"

namespace facenav::pictures {
namespace {

/// Colour (R, G, B) of a signed residual in -1 .. 1: blue, white, orange.
cv::Vec3b colourOf(double share) {
  const cv::Vec3d blue(40, 120, 255), white(245, 245, 245), orange(255, 120, 0);
  const double t = std::clamp(std::abs(share), 0.0, 1.0);
  const cv::Vec3d colour = (1 - t) * white + t * (share > 0 ? orange : blue);
  return {std::uint8_t(colour[0]), std::uint8_t(colour[1]), std::uint8_t(colour[2])};
}

void drawScale(cv::Mat& image, double full_mm) {
  const int height = std::max(8, image.rows / 40), width = image.cols / 3, left = height, top = height;
  for (int u = 0; u < width; ++u)
    cv::line(image, {left + u, top}, {left + u, top + height}, colourOf(2.0 * u / width - 1.0));
  char words[96];
  std::snprintf(words, sizeof words, "inside -%.1f mm      outside +%.1f mm    grey: not counted", full_mm,
                full_mm);
  const double size = 0.45 * image.rows / 480.0;
  drawFileWords(image, words, {left, top + height + int(36 * size)}, {size, cv::Scalar(255, 255, 255)});
}

}  // namespace

RgbImage drawSkinFit(const cv::Mat& plain_left, const stereo::FaceCloud& face,
                     const registration::AlignmentResult& alignment, double full_mm) {
  cv::Mat image;
  cv::cvtColor(plain_left, image, cv::COLOR_GRAY2RGB);
  image *= 0.6;
  const std::size_t count = std::min(face.left_px.size(), alignment.residual_mm.size());
  for (std::size_t p = 0; p < count; ++p) {
    const double residual_mm = alignment.residual_mm[p];
    const int u = int(std::lround(face.left_px[p].x())), v = int(std::lround(face.left_px[p].y()));
    if (u < 0 || v < 0 || u >= image.cols || v >= image.rows || !(std::abs(residual_mm) < 15.0)) continue;
    const cv::Vec3b colour =
        alignment.is_inlier[p] ? colourOf(residual_mm / full_mm) : cv::Vec3b(110, 110, 115);
    cv::Vec3b& pixel = image.at<cv::Vec3b>(v, u);
    for (int c = 0; c < 3; ++c) pixel[c] = std::uint8_t(0.35 * pixel[c] + 0.65 * colour[c]);
  }
  drawScale(image, full_mm);
  return toRgb(image);
}

}  // namespace facenav::pictures
