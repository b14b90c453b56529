#include "facenav/dicom/thumbnail.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/robust_statistics.h"
#include "pixels/pixel_decoder.h"
#include "series_scan.h"

namespace facenav::dicom {
namespace {

struct MiddleImage {
  int rows = 0, columns = 0;
  Eigen::Vector2d spacing_mm{1, 1};  // between columns, between rows
  bool is_inverted = false;
  std::vector<float> values;
};

MiddleImage readMiddleImage(const SeriesInfo& series) {
  FilePrefix file(series.thumbnail_file);
  const auto header = readSliceHeader(file);
  if (!header) throw Error("is not DICOM", series.thumbnail_file.string());
  const PixelDecoder decoder(file, *header);
  MiddleImage image;
  image.rows = header->voxels.rows;
  image.columns = header->voxels.columns;
  image.is_inverted = header->voxels.photometric == "MONOCHROME1";
  const auto& spacing_mm = header->images.front().spacing_mm;
  if (spacing_mm && spacing_mm->minCoeff() > 0.01) image.spacing_mm = *spacing_mm;
  image.values = decoder.image(series.thumbnail_frame);
  return image;
}

float quantile(std::vector<float> values, double fraction) {
  return selectRank(values, std::size_t(fraction * double(values.size() - 1)));
}

/// Mean over the voxels that the pixel covers, at least one.
float meanOver(const MiddleImage& image, double left, double right, double top, double bottom) {
  const int i0 = std::clamp(int(left), 0, image.columns - 1), j0 = std::clamp(int(top), 0, image.rows - 1);
  const int i1 = std::clamp(int(std::ceil(right)), i0 + 1, image.columns);
  const int j1 = std::clamp(int(std::ceil(bottom)), j0 + 1, image.rows);
  double sum = 0;
  for (int j = j0; j < j1; ++j)
    for (int i = i0; i < i1; ++i) sum += image.values[std::size_t(j) * image.columns + i];
  return float(sum / double((i1 - i0) * (j1 - j0)));
}

Thumbnail draw(const MiddleImage& image, int side_px) {
  const double width_mm = image.columns * image.spacing_mm[0], height_mm = image.rows * image.spacing_mm[1];
  const double scale = side_px / std::max(width_mm, height_mm);
  Thumbnail picture;
  picture.width_px = std::max(1, int(std::lround(width_mm * scale)));
  picture.height_px = std::max(1, int(std::lround(height_mm * scale)));
  picture.grey.resize(std::size_t(picture.width_px) * picture.height_px);
  const float low = quantile(image.values, 0.01), high = quantile(image.values, 0.995);
  const float gain = high > low ? 255.f / (high - low) : 0.f;
  const double across = double(image.columns) / picture.width_px,
               down = double(image.rows) / picture.height_px;
  for (int v = 0; v < picture.height_px; ++v)
    for (int u = 0; u < picture.width_px; ++u) {
      const float mean = meanOver(image, u * across, (u + 1) * across, v * down, (v + 1) * down);
      const float grey = std::clamp((mean - low) * gain, 0.f, 255.f);
      picture.grey[std::size_t(v) * picture.width_px + u] =
          std::uint8_t(std::lround(image.is_inverted ? 255.f - grey : grey));
    }
  return picture;
}

}  // namespace

std::optional<Thumbnail> makeThumbnail(const SeriesInfo& series, int side_px) {
  FACENAV_EXPECT(side_px >= 8 && side_px <= 1024, "thumbnail of an odd size");
  if (series.thumbnail_file.empty()) return std::nullopt;
  try {
    return draw(readMiddleImage(series), side_px);
  } catch (const Error&) {
    return std::nullopt;  // the list shows the series' problem
  }
}

}  // namespace facenav::dicom
