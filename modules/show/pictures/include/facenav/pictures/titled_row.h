#pragma once
// Arranges pictures side by side, each with a title: a sheet for the command line and reports. Needs no
// screen.

#include <string>
#include <vector>

#include "facenav/core/rgb_image.h"

namespace facenav::pictures {

struct TitledPicture {
  std::string title;
  RgbImage image;
};

/// Arranges the pictures in one row, top edges aligned, on a dark ground.
RgbImage titledRow(const std::vector<TitledPicture>& pictures);
/// Arranges rows below each other, left edges aligned.
RgbImage stacked(const std::vector<RgbImage>& rows);

}  // namespace facenav::pictures
