#pragma once
// Pictures side by side, each with a line of words over it: a sheet for the command line and reports. Drawn
// without a screen.

#include <string>
#include <vector>

#include "facenav/core/rgb_image.h"

namespace facenav::pictures {

struct TitledPicture {
  std::string title;  // letters of ASCII only
  RgbImage image;
};

/// In one row, top edges level, on a dark ground.
RgbImage titledRow(const std::vector<TitledPicture>& pictures);
/// One row under the other, left edges level.
RgbImage stacked(const std::vector<RgbImage>& rows);

}  // namespace facenav::pictures
