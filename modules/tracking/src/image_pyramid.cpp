#include "image_pyramid.h"

#include <cstdint>
#include <opencv2/imgproc.hpp>

namespace facenav::tracking {
namespace {

// The kernel along x, at every `step`-th pixel: reads from[-2] .. from[step * (count - 1) + 2].
template <int step>
void blurRow(const std::uint8_t* from, std::uint16_t* to, int count) {
  for (int i = 0, x = 0; i < count; ++i, x += step)
    to[i] = std::uint16_t(from[x - 2] + from[x + 2] + 4 * (from[x - 1] + from[x + 1]) + 6 * from[x]);
}

// And along y, over five rows of the above.
void blurColumn(const std::uint16_t* const rows[5], std::uint16_t* to, int count) {
  const std::uint16_t *a = rows[0], *b = rows[1], *c = rows[2], *d = rows[3], *e = rows[4];
  for (int x = 0; x < count; ++x) to[x] = std::uint16_t(a[x] + e[x] + 4 * (b[x] + d[x]) + 6 * c[x]);
}

// Every `step`-th pixel of `part` along both axes, blurred; the image must reach two pixels beyond.
template <int step>
cv::Mat1w blurred(const cv::Mat& grey, const cv::Rect& part) {
  constexpr int m = kBlurMargin_px;
  cv::Mat1w result((part.height + step - 1) / step, (part.width + step - 1) / step);
  cv::Mat1w ring(5, result.cols);
  for (int y = -m; y < step * (result.rows - 1) + 1 + m; ++y) {
    const int slot = (y + m) % 5;
    blurRow<step>(grey.ptr<std::uint8_t>(part.y + y) + part.x, ring.ptr<std::uint16_t>(slot), result.cols);
    if (y < m || (y - m) % step != 0) continue;
    const std::uint16_t* rows[5];
    for (int k = 0; k < 5; ++k) rows[k] = ring.ptr<std::uint16_t>((slot + 1 + k) % 5);
    blurColumn(rows, result.ptr<std::uint16_t>((y - m) / step), result.cols);
  }
  return result;
}

cv::Mat padded(const cv::Mat& grey) {
  cv::Mat wider;
  constexpr int m = kBlurMargin_px;
  cv::copyMakeBorder(grey, wider, m, m, m, m, cv::BORDER_REPLICATE);
  return wider;
}

}  // namespace

BlurredImage blurredPart(const cv::Mat& grey, const cv::Rect& box) {
  constexpr int m = kBlurMargin_px;
  const cv::Rect part = box & cv::Rect(m, m, std::max(0, grey.cols - 2 * m), std::max(0, grey.rows - 2 * m));
  BlurredImage result;
  result.origin = part.tl();
  if (part.area() > 0) result.pixels = blurred<1>(grey, part);
  return result;
}

ImagePyramid ImagePyramid::coarse(const cv::Mat& grey, cv::Point origin) {
  ImagePyramid pyramid;
  constexpr int m = kBlurMargin_px;
  pyramid.level[1].pixels = blurred<2>(padded(grey), {m, m, grey.cols, grey.rows});
  for (int l = 2; l < kLevels; ++l) cv::pyrDown(pyramid.level[l - 1].pixels, pyramid.level[l].pixels);
  for (int l = 0; l < kLevels; ++l) pyramid.level[l].origin = {origin.x >> l, origin.y >> l};
  return pyramid;
}

ImagePyramid::ImagePyramid(const cv::Mat& grey, cv::Point origin) : ImagePyramid(coarse(grey, origin)) {
  constexpr int m = kBlurMargin_px;
  level[0].pixels = blurred<1>(padded(grey), {m, m, grey.cols, grey.rows});
}

cv::Mat1f greyOf(const BlurredImage& image) {
  cv::Mat1f grey;
  image.pixels.convertTo(grey, CV_32F, 1.0 / kGreyScale);
  return grey;
}

}  // namespace facenav::tracking
