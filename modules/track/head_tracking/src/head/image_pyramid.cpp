#include "image_pyramid.h"

#include <algorithm>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace facenav::head_tracking {
namespace {

// The kernel along y, for five rows.
void blurColumns(const std::uint8_t* const rows[5], std::uint16_t* __restrict to, int count) {
  const std::uint8_t *a = rows[0], *b = rows[1], *c = rows[2], *d = rows[3], *e = rows[4];
  for (int x = 0; x < count; ++x) to[x] = std::uint16_t(a[x] + e[x] + 4 * (b[x] + d[x]) + 6 * c[x]);
}

// The kernel along x over the result of blurColumns, at every `step`-th pixel: reads from[0] .. from[step *
// (count - 1) + 4].
template <int step>
void blurRow(const std::uint16_t* __restrict from, std::uint16_t* __restrict to, int count) {
  for (int i = 0; i < count; ++i) {
    const std::uint16_t* f = from + step * i;
    to[i] = std::uint16_t(f[0] + f[4] + 4 * (f[1] + f[3]) + 6 * f[2]);
  }
}

// Every `step`-th pixel of `part` (inside the image) along both axes, blurred. The image's edge is repeated
// outside.
template <int step>
cv::Mat1w blurred(const cv::Mat& grey, const cv::Rect& part) {
  constexpr int m = kBlurMargin_px;
  cv::Mat1w result((part.height + step - 1) / step, (part.width + step - 1) / step);
  std::vector<std::uint16_t> columns(std::size_t(part.width + 2 * m));
  const int first = std::max(0, part.x - m), last = std::min(grey.cols, part.br().x + m);
  const auto from = columns.begin() + (first - part.x + m), end = columns.begin() + (last - part.x + m);
  for (int y = 0; y < result.rows; ++y) {
    const std::uint8_t* rows[5];
    for (int k = 0; k < 5; ++k)
      rows[k] = grey.ptr<std::uint8_t>(std::clamp(part.y + step * y + k - m, 0, grey.rows - 1)) + first;
    blurColumns(rows, &*from, last - first);
    std::fill(columns.begin(), from, *from), std::fill(end, columns.end(), *(end - 1));
    blurRow<step>(columns.data(), result.ptr<std::uint16_t>(y), result.cols);
  }
  return result;
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
  pyramid.level[1].pixels = blurred<2>(grey, {{}, grey.size()});
  for (int l = 2; l < kLevels; ++l) cv::pyrDown(pyramid.level[l - 1].pixels, pyramid.level[l].pixels);
  for (int l = 0; l < kLevels; ++l) pyramid.level[l].origin = {origin.x >> l, origin.y >> l};
  return pyramid;
}

ImagePyramid::ImagePyramid(const cv::Mat& grey, cv::Point origin) : ImagePyramid(coarse(grey, origin)) {
  level[0].pixels = blurred<1>(grey, {{}, grey.size()});
}

cv::Mat1f greyOf(const BlurredImage& image) {
  cv::Mat1f grey;
  image.pixels.convertTo(grey, CV_32F, 1.0 / kGreyScale);
  return grey;
}

}  // namespace facenav::head_tracking
