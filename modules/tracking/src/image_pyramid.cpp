#include "image_pyramid.h"

#include <cstdint>
#include <opencv2/imgproc.hpp>

namespace facenav::tracking {
namespace {

// The kernel along x: reads from[-2] .. from[count + 1].
void blurRow(const std::uint8_t* from, std::uint16_t* to, int count) {
  for (int x = 0; x < count; ++x)
    to[x] = std::uint16_t(from[x - 2] + from[x + 2] + 4 * (from[x - 1] + from[x + 1]) + 6 * from[x]);
}

// And along y, over five rows of the above.
void blurColumn(const std::uint16_t* const rows[5], std::uint16_t* to, int count) {
  const std::uint16_t *a = rows[0], *b = rows[1], *c = rows[2], *d = rows[3], *e = rows[4];
  for (int x = 0; x < count; ++x) to[x] = std::uint16_t(a[x] + e[x] + 4 * (b[x] + d[x]) + 6 * c[x]);
}

cv::Mat1w everySecond(const cv::Mat1w& image) {
  cv::Mat1w half((image.rows + 1) / 2, (image.cols + 1) / 2);
  for (int y = 0; y < half.rows; ++y) {
    const std::uint16_t* from = image.ptr<std::uint16_t>(2 * y);
    std::uint16_t* to = half.ptr<std::uint16_t>(y);
    for (int x = 0; x < half.cols; ++x) to[x] = from[2 * x];
  }
  return half;
}

}  // namespace

BlurredImage blurredPart(const cv::Mat& grey, const cv::Rect& box) {
  constexpr int m = kBlurMargin_px;
  const cv::Rect part = box & cv::Rect(m, m, std::max(0, grey.cols - 2 * m), std::max(0, grey.rows - 2 * m));
  BlurredImage blurred;
  blurred.origin = part.tl();
  if (part.area() == 0) return blurred;
  blurred.pixels.create(part.size());
  cv::Mat1w ring(5, part.width);
  for (int y = -m; y < part.height + m; ++y) {
    const int slot = (y + m) % 5;
    blurRow(grey.ptr<std::uint8_t>(part.y + y) + part.x, ring.ptr<std::uint16_t>(slot), part.width);
    if (y < m) continue;
    const std::uint16_t* rows[5];
    for (int k = 0; k < 5; ++k) rows[k] = ring.ptr<std::uint16_t>((slot + 1 + k) % 5);
    blurColumn(rows, blurred.pixels.ptr<std::uint16_t>(y - m), part.width);
  }
  return blurred;
}

ImagePyramid::ImagePyramid(const cv::Mat& grey) {
  cv::Mat padded;
  constexpr int m = kBlurMargin_px;
  cv::copyMakeBorder(grey, padded, m, m, m, m, cv::BORDER_REPLICATE);
  level[0].pixels = blurredPart(padded, {0, 0, padded.cols, padded.rows}).pixels;
  level[1].pixels = everySecond(level[0].pixels);
  for (int l = 2; l < kLevels; ++l) cv::pyrDown(level[l - 1].pixels, level[l].pixels);
}

cv::Mat1f greyOf(const BlurredImage& image) {
  cv::Mat1f grey;
  image.pixels.convertTo(grey, CV_32F, 1.0 / kGreyScale);
  return grey;
}

}  // namespace facenav::tracking
