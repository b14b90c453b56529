#include "dot_slide.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "script/dice.h"

namespace facenav::room {

cv::Mat drawDotSlide(const DotSlide& slide, const cv::Size& size, std::uint64_t seed) {
  cv::Mat picture = cv::Mat::zeros(size, CV_8U);
  Dice dice(seed * 7177 + 3);
  const int side = std::max(1, int(std::lround(slide.size_px)));
  for (double y = 0.0; y < size.height; y += slide.pitch_px)
    for (double x = 0.0; x < size.width; x += slide.pitch_px) {
      const double free_px = std::max(0.0, slide.pitch_px - side);
      const int left = int(x + dice.between(0.0, free_px)), top = int(y + dice.between(0.0, free_px));
      if (dice.between(0.0, 1.0) >= slide.filled) continue;
      picture(cv::Rect(left, top, side, side) & cv::Rect({}, size)) = 255;
    }
  if (slide.blur_px > 0.0) cv::GaussianBlur(picture, picture, {}, slide.blur_px);
  return picture;
}

}  // namespace facenav::room
