#include "value_check.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/robust_statistics.h"
#include "pixels/pixel_decoder.h"
#include "series_scan.h"

namespace facenav::dicom {
namespace {

float atShare(std::vector<float> values, double fraction) {
  return selectRank(values, std::size_t(fraction * double(values.size() - 1)));
}

/// True near the middle of the values' range, 0 to 1.
bool isMiddle(float place) { return place > 0.25f && place < 0.75f; }

/// True if neighbours differ by a good part of the range: by 0.29 of it (median) in uniform noise.
bool isNoise(const std::vector<float>& steps, float range) { return atShare(steps, 0.5) > 0.15f * range; }

/// True if values of both signs are frequent.
bool isSigned(const std::vector<float>& values) {
  const auto negative = std::count_if(values.begin(), values.end(), [](float v) { return v < 0; });
  return isMiddle(float(negative) / float(values.size()));
}

}  // namespace

bool hasDarkAir(const std::vector<float>& values, int rows, int columns) {
  // A head lies in the middle: of the four corners, neck and nose reach one or two at most, on any plane.
  constexpr int kMostWithTissue = 1;
  const int high = std::max(1, rows / 10), wide = std::max(2, columns / 10);
  const float low = atShare(values, 0.01), range = atShare(values, 0.99) - low;
  if (!(range > 0) || columns < 2 * wide) return true;
  int not_dark = 0;
  for (const int top : {0, rows - high})
    for (const int left : {0, columns - wide}) {
      std::vector<float> corner, steps;
      for (int j = top; j < top + high; ++j)
        for (int i = left; i < left + wide; ++i) {
          const float* here = &values[std::size_t(j) * std::size_t(columns) + std::size_t(i)];
          corner.push_back(*here);
          if (i > left) steps.push_back(std::abs(here[0] - here[-1]));
        }
      not_dark +=
          isMiddle((atShare(corner, 0.5) - low) / range) && (isNoise(steps, range) || isSigned(corner));
    }
  return not_dark < 4 - kMostWithTissue;
}

bool hasDarkAir(const SeriesInfo& series) {
  if (series.thumbnail_file.empty()) return true;
  try {
    FilePrefix file(series.thumbnail_file);
    const auto header = readSliceHeader(file);
    if (!header) return true;
    const auto values = PixelDecoder(file, *header).image(series.thumbnail_frame);
    return hasDarkAir(values, header->voxels.rows, header->voxels.columns);
  } catch (const Error&) {
    return true;  // the loader names the fault
  }
}

}  // namespace facenav::dicom
