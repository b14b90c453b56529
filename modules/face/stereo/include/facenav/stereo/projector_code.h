#pragma once
// ProjectorCode: pictures that tell, in a camera's pictures of them, which projector pixel lights each place:
// Gray code for the half period, four phase shifts of a cosine for the place in it (S. Zhang, "High-speed 3D
// shape measurement with structured light methods: a review", Opt. Lasers Eng. 106, 2018). Projector pixels
// as camera pixels: (0, 0) is the centre of the top-left one.

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace facenav::stereo {

struct ProjectorCode {
  int width_px = 1024, height_px = 768;
  int period_px = 16;  // of the cosine; even
};

/// White, black, then for x and for y: Gray code from the coarsest bit, four phases. 8-bit, 1 channel.
std::vector<cv::Mat> codePictures(const ProjectorCode& code);

/// What one camera saw of all pictures.
struct DecodedCode {
  cv::Mat place;             // 32-bit, 2 channels: projector x and y, px; NaN where the light does not reach
  double lit_share = 0;      // of the picture
  double contrast_grey = 0;  // white against black, median over the lit pixels
  double saturated_share = 0;  // of the lit pixels
  double sharpness = 0;        // contrast of the cosine against white and black: 1 sharp, 0 blurred away
  /// What to do about the projector's light and focus, in words; empty: they are good.
  std::vector<std::string> advice() const;
};

/// `pictures`: 8-bit grey, in the order of codePictures, taken while nothing moved. Throws Error: their
/// number or sizes.
DecodedCode decode(const std::vector<cv::Mat>& pictures, const ProjectorCode& code);

}  // namespace facenav::stereo
