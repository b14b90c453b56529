#include "film.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace facenav::room {
namespace {

/// Veiling glare in grey levels: a plane over the image, nowhere below 0.
cv::Mat hazeOver(const cv::Size& size, const FilmOptions& options) {
  cv::Mat haze(size, CV_32F);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const double right = 2.0 * x / size.width - 1.0, down = 2.0 * y / size.height - 1.0;
      const double share = 1.0 + options.haze_right * right + options.haze_down * down;
      haze.at<float>(y, x) = float(options.haze_grey * std::max(0.0, share));
    }
  return haze;
}

cv::Mat compressed(const cv::Mat& grey, int quality) {
  std::vector<std::uint8_t> file;
  cv::imencode(".jpg", grey, file, {cv::IMWRITE_JPEG_QUALITY, quality});
  return cv::imdecode(file, cv::IMREAD_GRAYSCALE);
}

}  // namespace

cv::Mat develop(const cv::Mat& radiance, const FilmOptions& options, std::uint64_t noise_seed) {
  cv::Mat light = radiance.clone(), grey;  // Mat operators below work in place
  if (options.blur_px > 0.0)
    cv::GaussianBlur(radiance, light, {}, options.blur_px, options.blur_px, cv::BORDER_REPLICATE);
  light = light * options.exposure;
  if (options.gamma != 1.0) cv::pow(cv::max(light, 0.0), 1.0 / options.gamma, light);
  light = light * 255.0;
  if (options.haze_grey != 0.0) light = light + hazeOver(light.size(), options);
  if (options.noise_grey > 0.0) {
    cv::Mat noise(light.size(), CV_32F);
    cv::RNG random(noise_seed);
    random.fill(noise, cv::RNG::NORMAL, 0.0, options.noise_grey);
    light = light + noise;
  }
  light.convertTo(grey, CV_8U);
  return options.jpeg_quality > 0 ? compressed(grey, options.jpeg_quality) : grey;
}

}  // namespace facenav::room
