#include "facenav/pictures/titled_row.h"

#include <algorithm>
#include <cstring>

#include "drawn_words.h"

namespace facenav::pictures {
namespace {

constexpr int kRowTitle_px = 26, kBetween_px = 8;

void paste(const RgbImage& image, RgbImage& onto, int left, int top) {
  for (int v = 0; v < image.height_px; ++v)
    std::memcpy(onto.pixel(left, top + v), image.pixel(0, v), std::size_t(image.width_px) * 3);
}

}  // namespace

RgbImage titledRow(const std::vector<TitledPicture>& pictures) {
  int width = 0, height = 0;
  for (const auto& picture : pictures) {
    width += picture.image.width_px + kBetween_px;
    height = std::max(height, picture.image.height_px);
  }
  RgbImage row(std::max(1, width - kBetween_px), height + kRowTitle_px);
  cv::Mat canvas(row.height_px, row.width_px, CV_8UC3, row.rgb.data());
  int left = 0;
  for (const auto& picture : pictures) {
    paste(picture.image, row, left, kRowTitle_px);
    drawFileWords(canvas, picture.title, {left + 6, kRowTitle_px - 8}, {0.45, cv::Scalar(200, 205, 215)});
    left += picture.image.width_px + kBetween_px;
  }
  return row;
}

RgbImage stacked(const std::vector<RgbImage>& rows) {
  int width = 0, height = 0;
  for (const auto& row : rows) width = std::max(width, row.width_px), height += row.height_px;
  RgbImage sheet(width, height);
  int top = 0;
  for (const auto& row : rows) {
    paste(row, sheet, 0, top);
    top += row.height_px;
  }
  return sheet;
}

}  // namespace facenav::pictures
