#pragma once
// A small grey image of a series, for lists: its middle image as stored by the scanner, windowed between the
// 1st and 99.5th percentile, in the patient's proportions. Fast enough to be made while a list is shown.

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

/// Makes the thumbnail; its longer side has `side_px` (8 to 1024) pixels. nullopt without a readable grey
/// image (reports, colour, damage): a missing image must not stop a list.
std::optional<Thumbnail> makeThumbnail(const SeriesInfo& series, int side_px = 128);

}  // namespace facenav::dicom
