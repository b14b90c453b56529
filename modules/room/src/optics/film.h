#pragma once
// Film: from linear light to the camera's 8-bit image: lens blur, exposure, tone curve, sensor noise.

#include <cstdint>
#include <opencv2/core.hpp>

namespace facenav::room {

struct FilmOptions {
  double blur_px = 0.6;   // standard deviation of the lens's point spread
  double exposure = 1.0;  // grey = 255 * (exposure * radiance)^(1 / gamma)
  double gamma = 1.0;
  double noise_grey = 1.5;  // standard deviation of the sensor noise, grey levels
};

/// `noise_seed`: the same seed gives the same noise.
cv::Mat develop(const cv::Mat& radiance, const FilmOptions& options, std::uint64_t noise_seed);

}  // namespace facenav::room
