#pragma once
// Film: converts linear light to the camera's 8-bit grey image: lens blur, colour sensor, exposure, tone
// curve, veiling glare, sensor noise, compression.

#include <cstdint>
#include <opencv2/core.hpp>

namespace facenav::room {

struct FilmOptions {
  double blur_px = 0.6;   // standard deviation of the lens's point spread
  double exposure = 1.0;  // grey = 255 * (exposure * radiance)^(1 / gamma)
  double gamma = 1.0;
  double noise_grey = 1.5;                   // standard deviation of the sensor noise, grey levels
  double haze_grey = 0.0;                    // veiling glare: mean of the added grey levels over the image
  double haze_right = 0.0, haze_down = 0.0;  // its gradient: share of haze_grey from the centre to the border
  int jpeg_quality = 0;                      // 1..100: quality of a JPEG compression; 0: not compressed
  // Weights of red and blue in the grey; green has the rest. With equal weights colour has no effect, since a
  // surface's blue is darker by the amount that its red is brighter.
  double red_share = 1.0 / 3.0, blue_share = 1.0 / 3.0;
  bool is_bayer = false;  // colour sensor (RGGB): the image is demosaiced, then grey

  bool needsColour() const { return is_bayer || red_share != blue_share; }
};

/// Develops an 8-bit image of the size of `radiance` (float, linear light). `noise_seed`: the same seed gives
/// the same noise. `red`: the amount by which red is brighter and blue darker (float); empty: everything is
/// grey.
cv::Mat develop(const cv::Mat& radiance, const FilmOptions& options, std::uint64_t noise_seed,
                const cv::Mat& red = {});

}  // namespace facenav::room
