#pragma once
// Undistorted pixels for renderers of test scenes. To undistort takes most of the time of a rendered picture,
// and tests render many pictures with the same cameras.

#include <algorithm>
#include <cmath>
#include <limits>
#include <list>
#include <memory>
#include <opencv2/core.hpp>
#include <utility>
#include <vector>

#include "facenav/cameras/stereo_rig.h"

namespace facenav::testing {

/// Rays through the pixels of one camera, moved by `offset_px`: normalised image coordinates, computed when
/// first asked for.
class PixelRays {
 public:
  PixelRays(const cameras::CameraModel& camera, cv::Size size, const Eigen::Vector2d& offset_px)
      : camera_{camera.k, camera.distortion.clone()},
        offset_px_(offset_px),
        size_(size),
        rays_(std::size_t(size.area()), Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN())) {
  }

  /// `u`, `v`: inside the picture.
  const Eigen::Vector2d& at(int u, int v) {
    Eigen::Vector2d& ray = rays_[std::size_t(v) * std::size_t(size_.width) + std::size_t(u)];
    if (std::isnan(ray.x())) ray = cameras::undistort(camera_, {u + offset_px_.x(), v + offset_px_.y()});
    return ray;
  }
  bool isOf(const cameras::CameraModel& camera, cv::Size size, const Eigen::Vector2d& offset_px) const {
    return size == size_ && offset_px == offset_px_ && camera.k == camera_.k &&
           camera.distortion.size() == camera_.distortion.size() &&
           camera.distortion.type() == camera_.distortion.type() &&
           (camera.distortion.empty() || cv::norm(camera.distortion, camera_.distortion, cv::NORM_INF) == 0);
  }

 private:
  cameras::CameraModel camera_;
  Eigen::Vector2d offset_px_;
  cv::Size size_;
  std::vector<Eigen::Vector2d> rays_;
};

/// The rays of a camera's pixels. Each thread keeps those it used last.
inline std::shared_ptr<PixelRays> pixelRays(const cameras::CameraModel& camera, cv::Size size,
                                            const Eigen::Vector2d& offset_px = Eigen::Vector2d::Zero()) {
  constexpr std::size_t kKept = 20;  // two cameras with nine rays a pixel
  thread_local std::list<std::shared_ptr<PixelRays>> kept;
  const auto found = std::find_if(kept.begin(), kept.end(),
                                  [&](const auto& rays) { return rays->isOf(camera, size, offset_px); });
  if (found != kept.end()) {
    kept.splice(kept.begin(), kept, found);
  } else {
    kept.push_front(std::make_shared<PixelRays>(camera, size, offset_px));
    if (kept.size() > kKept) kept.pop_back();
  }
  return kept.front();
}

}  // namespace facenav::testing
