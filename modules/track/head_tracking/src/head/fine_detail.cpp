#include "fine_detail.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace facenav::head_tracking {
namespace {

constexpr double kNoiseInDetail =
    0.041;                           // variance of level 1 minus its 3 x 3 mean, relative to the sensor's
constexpr int kLeastArea_px2 = 100;  // in pixels of the level

}  // namespace

std::optional<double> fineDetail(const ImagePyramid& image, const cv::Rect& box, double noise_grey) {
  const cv::Mat1w& level = image.level[1].pixels;
  const cv::Rect half =
      cv::Rect(box.x / 2, box.y / 2, box.width / 2, box.height / 2) & cv::Rect({}, level.size());
  if (half.area() < kLeastArea_px2) return std::nullopt;
  cv::Mat1f grey, smooth, smoother;
  level(half).convertTo(grey, CV_32F, 1.0 / kGreyScale);
  cv::blur(grey, smooth, {3, 3});
  cv::blur(grey, smoother, {9, 9});
  const double fine = cv::norm(grey, smooth, cv::NORM_L2SQR) / half.area(),
               noise = kNoiseInDetail * noise_grey * noise_grey;
  return std::sqrt(std::max(0.0, fine - noise) * half.area()) /
         (1e-3 + cv::norm(smooth, smoother, cv::NORM_L2));
}

}  // namespace facenav::head_tracking
