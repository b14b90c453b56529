#pragma once
// A small grey picture of a series, for lists: its middle image as the scanner stored it, windowed between
// the 1st and 99.5th percentile, in the patient's proportions. Cheap enough to be made while a list is shown.

#include <cstdint>
#include <optional>
#include <vector>

#include "facenav/dicom/series.h"

namespace facenav::dicom {

/// Row-major, top row first, 8 bit.
struct Thumbnail {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> grey;
};

/// The longer side has `side_px` (8 to 1024) pixels. Nothing for what holds no grey image that can be read
/// (reports, colour, damage): a picture is never what stops a list.
std::optional<Thumbnail> makeThumbnail(const SeriesInfo& series, int side_px = 128);

}  // namespace facenav::dicom
