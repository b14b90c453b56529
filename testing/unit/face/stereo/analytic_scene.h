#pragma once
// A rectified pair in closed form: a smooth random texture on a surface whose disparity is a plane. It has no
// pixels, noise or interpolation, so that any error is the matcher's.

#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "facenav/stereo/rectification.h"

namespace facenav::stereo::testing {

/// A sum of cosines of 5 to 14 px, about 120 grey levels in the mean.
class Texture {
 public:
  explicit Texture(std::uint64_t seed, int waves = 60) {
    cv::RNG random{seed};
    for (int i = 0; i < waves; ++i) {
      const double turn = random.uniform(0.0, 2 * M_PI), k = 2 * M_PI / random.uniform(5.0, 14.0);
      waves_.push_back({k * std::cos(turn), k * std::sin(turn), random.uniform(0.0, 2 * M_PI)});
    }
  }
  double at(double x, double y) const {
    double sum = 0;
    for (const auto& w : waves_) sum += std::cos(w.kx * x + w.ky * y + w.phase);
    return 120 + 40 * sum / std::sqrt(0.5 * double(waves_.size()));
  }

 private:
  struct Wave {
    double kx, ky, phase;
  };
  std::vector<Wave> waves_;
};

/// disparity = d + a x + b y at the left pixel (x, y).
struct DisparityPlane {
  double d, a = 0, b = 0;
  double at(double x, double y) const { return d + a * x + b * y; }
};

struct AnalyticScene {
  Rectification rectification;
  RectifiedPair images;
  DisparityPlane plane;
};

/// f 800 px, baseline 120 mm. `rows_px`: the right camera sees everything this much further down.
inline AnalyticScene analyticScene(const DisparityPlane& plane, int width = 160, int height = 120,
                                   int disparities = 48, double rows_px = 0.0, std::uint64_t seed = 5) {
  AnalyticScene scene;
  scene.plane = plane;
  Rectification& r = scene.rectification;
  r.f_px = 800, r.baseline_mm = 120, r.disparities = disparities;
  r.cx_left_px = r.cx_right_px = width / 2.0, r.cy_px = height / 2.0;
  r.left_mask = cv::Mat(height, width, CV_8U, cv::Scalar(255));
  r.right_mask = cv::Mat(height, width + disparities, CV_8U, cv::Scalar(255));
  scene.images.left.create(height, width, CV_32F);
  scene.images.right.create(height, width + disparities, CV_32F);
  const Texture texture(seed);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) scene.images.left.at<float>(y, x) = float(texture.at(x, y));
    for (int column = 0; column < width + disparities; ++column) {
      const double seen_y = y - rows_px;  // of the left row that this right row shows
      const double x = (column - disparities + plane.d + plane.b * seen_y) / (1 - plane.a);
      scene.images.right.at<float>(y, column) = float(texture.at(x, seen_y));
    }
  }
  return scene;
}

/// The plane's disparity map with slopes, as a matcher would give it.
inline cv::Mat truthOf(const AnalyticScene& scene) {
  cv::Mat truth(scene.images.left.size(), CV_32F);
  for (int y = 0; y < truth.rows; ++y)
    for (int x = 0; x < truth.cols; ++x) truth.at<float>(y, x) = float(scene.plane.at(x, y));
  return truth;
}

struct Accuracy {
  double found = 0, mean_px = 0, rms_px = 0, worst_px = 0;
};

/// Accuracy over the pixels `margin` inside the image.
inline Accuracy accuracyOf(const cv::Mat& disparity, const cv::Mat& truth, int margin = 12) {
  Accuracy a;
  int count = 0, all = 0;
  for (int y = margin; y < truth.rows - margin; ++y)
    for (int x = margin; x < truth.cols - margin; ++x, ++all) {
      const double d = double(disparity.at<float>(y, x)) - double(truth.at<float>(y, x));
      if (std::isnan(d)) continue;
      ++count;
      a.mean_px += d, a.rms_px += d * d, a.worst_px = std::max(a.worst_px, std::abs(d));
    }
  a.found = double(count) / all;
  a.mean_px /= std::max(1, count);
  a.rms_px = std::sqrt(a.rms_px / std::max(1, count));
  return a;
}

}  // namespace facenav::stereo::testing
