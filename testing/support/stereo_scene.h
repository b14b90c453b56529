#pragma once
// Scenes for stereo tests: a plane or a sphere lit by a dot projector, seen by any rig. Rendered by ray
// casting from each pixel (3 x 3 samples), with the exact distance along each left ray as truth.

#include <cmath>
#include <functional>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/stereo/dot_pattern.h"
#include "support/pixel_rays.h"
#include "support/stereo_rigs.h"

namespace facenav::testing {

/// Distance along the ray (unit direction) to the surface, NaN if it misses. Camera frame, mm.
using Surface = std::function<double(const Eigen::Vector3d& origin_mm, const Eigen::Vector3d& direction)>;

inline Surface plane(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& normal) {
  return [=](const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
    const double t = normal.dot(point_mm - origin) / normal.dot(direction);
    return t > 0 ? t : std::numeric_limits<double>::quiet_NaN();
  };
}

inline Surface sphere(const Eigen::Vector3d& centre_mm, double radius_mm) {
  return [=](const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
    const Eigen::Vector3d to_centre = centre_mm - origin;
    const double along = to_centre.dot(direction),
                 square = radius_mm * radius_mm - to_centre.squaredNorm() + along * along;
    return square > 0 ? along - std::sqrt(square) : std::numeric_limits<double>::quiet_NaN();
  };
}

/// The nearer of two surfaces.
inline Surface both(const Surface& a, const Surface& b) {
  return [=](const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
    const double ta = a(origin, direction), tb = b(origin, direction);
    return std::isnan(ta) ? tb : (std::isnan(tb) ? ta : std::min(ta, tb));
  };
}

/// A projector of f px beside the left camera, looking along z; its lens blurs the pattern slightly.
struct Projector {
  Eigen::Vector3d centre_mm{60, -80, 0};
  double f_px = 1300;
  cv::Mat pattern = stereo::makeDotPattern(stereo::DotPattern::dense, 5);
  double blur_px = 0.8;
};

struct SceneOptions {
  double ambient_grey = 50, dots_grey = 130, noise_grey = 1.5;
  double right_gain = 1.0, right_offset_grey = 0.0;
  int seed = 1;
  Projector projector;
};

class Scene {
 public:
  Scene(Surface surface, const SceneOptions& options) : surface_(std::move(surface)), options_(options) {
    cv::Mat pattern;
    options.projector.pattern.convertTo(pattern, CV_32F, 1.0 / 255);
    cv::GaussianBlur(pattern, pattern_, {}, options.projector.blur_px);
  }

  cameras::StereoFrame render(const cameras::StereoRig& rig) const {
    cameras::StereoFrame frame;
    const auto left_T_right = rig.right_T_left.inverse().isometry();
    frame.left = image(rig, rig.left, Eigen::Isometry3d::Identity(), 1.0, 0.0, options_.seed);
    frame.right = image(rig, rig.right, left_T_right, options_.right_gain, options_.right_offset_grey,
                        options_.seed + 1);
    return frame;
  }

  /// True distance along the ray of a left pixel, NaN if it hits nothing.
  double distance_mm(const cameras::StereoRig& rig, const Eigen::Vector2d& left_px) const {
    return surface_(Eigen::Vector3d::Zero(),
                    cameras::undistort(rig.left, left_px).homogeneous().normalized());
  }

 private:
  double brightness(const Eigen::Vector3d& p_mm) const {
    const Projector& projector = options_.projector;
    const Eigen::Vector3d q = p_mm - projector.centre_mm;
    const double x = projector.f_px * q.x() / q.z() + 0.5 * pattern_.cols,
                 y = projector.f_px * q.y() / q.z() + 0.5 * pattern_.rows;
    const int i = int(std::floor(x)), j = int(std::floor(y));
    if (i < 0 || j < 0 || i + 1 >= pattern_.cols || j + 1 >= pattern_.rows) return options_.ambient_grey;
    const double fx = x - i, fy = y - j;
    const double dots =
        (pattern_.at<float>(j, i) * (1 - fx) + pattern_.at<float>(j, i + 1) * fx) * (1 - fy) +
        (pattern_.at<float>(j + 1, i) * (1 - fx) + pattern_.at<float>(j + 1, i + 1) * fx) * fy;
    return options_.ambient_grey + options_.dots_grey * dots;
  }

  cv::Mat image(const cameras::StereoRig& rig, const cameras::CameraModel& camera,
                const Eigen::Isometry3d& left_T_camera, double gain, double offset_grey, int seed) const {
    cv::Mat grey(rig.height_px, rig.width_px, CV_64F), noise(grey.size(), CV_64F), out;
    constexpr int kSamples = 3;
    std::vector<std::shared_ptr<PixelRays>> rays;
    for (int i = 0; i < kSamples * kSamples; ++i)
      rays.push_back(
          pixelRays(camera, grey.size(),
                    {(i % kSamples - 1) / double(kSamples), (i / kSamples - 1) / double(kSamples)}));
    for (int y = 0; y < grey.rows; ++y)
      for (int x = 0; x < grey.cols; ++x) {
        double sum = 0;
        for (int i = 0; i < kSamples * kSamples; ++i) {
          const Eigen::Vector3d ray =
              left_T_camera.linear() * rays[std::size_t(i)]->at(x, y).homogeneous().normalized();
          const double t = surface_(left_T_camera.translation(), ray);
          if (!std::isnan(t)) sum += brightness(left_T_camera.translation() + t * ray);
        }
        grey.at<double>(y, x) = gain * sum / (kSamples * kSamples) + offset_grey;
      }
    cv::GaussianBlur(grey, grey, {}, 0.5);
    cv::RNG random{std::uint64_t(seed)};
    random.fill(noise, cv::RNG::NORMAL, 0, options_.noise_grey);
    cv::Mat(grey + noise).convertTo(out, CV_8U);
    return out;
  }

  Surface surface_;
  SceneOptions options_;
  cv::Mat pattern_;
};

}  // namespace facenav::testing
