#include "film.h"

#include <opencv2/imgproc.hpp>

namespace facenav::room {

cv::Mat develop(const cv::Mat& radiance, const FilmOptions& options, std::uint64_t noise_seed) {
  cv::Mat light = radiance.clone(), grey;  // Mat operators below work in place
  if (options.blur_px > 0.0)
    cv::GaussianBlur(radiance, light, {}, options.blur_px, options.blur_px, cv::BORDER_REPLICATE);
  light = light * options.exposure;
  if (options.gamma != 1.0) cv::pow(cv::max(light, 0.0), 1.0 / options.gamma, light);
  light = light * 255.0;
  if (options.noise_grey > 0.0) {
    cv::Mat noise(light.size(), CV_32F);
    cv::RNG random(noise_seed);
    random.fill(noise, cv::RNG::NORMAL, 0.0, options.noise_grey);
    light = light + noise;
  }
  light.convertTo(grey, CV_8U);
  return grey;
}

}  // namespace facenav::room
