#include "film.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace facenav::room {
namespace {

/// Veiling glare in grey levels: a linear gradient over the image, never below 0.
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

cv::Mat compressed(const cv::Mat& image, int quality) {
  if (quality <= 0) return image;
  std::vector<std::uint8_t> file;
  cv::imencode(".jpg", image, file, {cv::IMWRITE_JPEG_QUALITY, quality});
  return cv::imdecode(file, image.channels() == 1 ? cv::IMREAD_GRAYSCALE : cv::IMREAD_COLOR);
}

cv::Mat blurred(const cv::Mat& light, double blur_px) {
  cv::Mat soft = light.clone();  // a copy, because callers change it in place
  if (blur_px > 0.0) cv::GaussianBlur(light, soft, {}, blur_px, blur_px, cv::BORDER_REPLICATE);
  return soft;
}

/// Light that each photosite of an RGGB mosaic receives.
cv::Mat mosaic(const cv::Mat& green, const cv::Mat& red) {
  cv::Mat seen = green.clone();
  for (int y = 0; y < seen.rows; ++y)
    for (int x = y % 2; x < seen.cols; x += 2)
      seen.at<float>(y, x) += y % 2 ? -red.at<float>(y, x) : red.at<float>(y, x);
  return seen;
}

/// Linear light on the sensor, after the lens blur.
cv::Mat onSensor(const cv::Mat& radiance, const cv::Mat& red, const FilmOptions& options) {
  const cv::Mat light = blurred(radiance, options.blur_px);
  if (red.empty() || !options.needsColour()) return light;
  const cv::Mat colour = blurred(red, options.blur_px);
  if (options.is_bayer) return mosaic(light, colour);
  return light + (options.red_share - options.blue_share) * colour;
}

/// Demosaics, compresses in colour as colour cameras do, then converts to grey.
cv::Mat greyOfMosaic(const cv::Mat& seen, const FilmOptions& options) {
  cv::Mat colour, grey;
  cv::cvtColor(seen, colour, cv::COLOR_BayerBG2BGR);  // BayerBG is OpenCV's name for RGGB
  colour = compressed(colour, options.jpeg_quality);
  const double red = options.red_share, blue = options.blue_share;
  cv::transform(colour, grey, cv::Matx13d(blue, 1.0 - red - blue, red));
  return grey;
}

}  // namespace

cv::Mat develop(const cv::Mat& radiance, const FilmOptions& options, std::uint64_t noise_seed,
                const cv::Mat& red) {
  cv::Mat light = onSensor(radiance, red, options), grey;
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
  return options.is_bayer ? greyOfMosaic(grey, options) : compressed(grey, options.jpeg_quality);
}

}  // namespace facenav::room
