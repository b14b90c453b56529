#pragma once
// DotSlide: a projector's picture of random dots of any size and density.

#include <cstdint>
#include <opencv2/core.hpp>

namespace facenav::room {

struct DotSlide {
  double pitch_px = 6.0, size_px = 2.0;  // of the places of dots; side of a dot
  double filled = 1.0;                   // share of places with a dot
  double blur_px = 0.4;                  // the projector's focus
};

/// 8-bit, 1 channel. The same seed gives the same slide.
cv::Mat drawDotSlide(const DotSlide& slide, const cv::Size& size, std::uint64_t seed);

}  // namespace facenav::room
