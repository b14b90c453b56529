#pragma once
// ProjectorCode: pictures from which a camera decodes which projector pixel lights each place. Gray code
// gives the half period, four phase shifts of a cosine the place in it (S. Zhang, "High-speed 3D shape
// measurement with structured light methods: a review", Opt. Lasers Eng. 106, 2018). Projector pixels are
// defined like camera pixels: (0, 0) is the centre of the top-left one.

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace facenav::stereo {

struct ProjectorCode {
  int width_px = 1024, height_px = 768;
  int period_px = 16;  // period of the cosine; even
};

/// White, black, then for x and for y: Gray code from the coarsest bit, four phases. 8-bit, 1 channel.
std::vector<cv::Mat> codePictures(const ProjectorCode& code);

/// The code as decoded from one camera's pictures.
struct DecodedCode {
  cv::Mat place;               // 32-bit, 2 channels: projector x and y, px; NaN outside its light
  double lit_share = 0;        // lit share of the picture
  double contrast_grey = 0;    // white minus black, median over the lit pixels
  double saturated_share = 0;  // share of the lit pixels that are saturated
  double sharpness = 0;        // contrast of the cosine against white and black: 1 sharp, 0 blurred
  /// Advice to the user about the projector's light and focus; empty if they are good.
  std::vector<std::string> advice() const;
};

/// `pictures`: 8-bit grey, in the order of codePictures, taken while nothing moved. Throws Error if their
/// number or sizes are wrong.
DecodedCode decode(const std::vector<cv::Mat>& pictures, const ProjectorCode& code);

}  // namespace facenav::stereo
