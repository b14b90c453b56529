#include "wall.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/parallel_for.h"
#include "facenav/geometry/rotation.h"
#include "noise_field.h"

namespace facenav::room {
namespace {

/// Triangle wave of period 1, -1 .. 1, clipped to a square wave with soft edges.
double wave(double x) {
  const double within = x - std::floor(x);
  return std::clamp(12.0 * (std::abs(within - 0.5) - 0.25), -1.0, 1.0);
}

}  // namespace

double patternAt(Pattern pattern, double period_mm, double x_mm, double y_mm) {
  const double x = x_mm / period_mm, y = y_mm / period_mm;
  switch (pattern) {
    case Pattern::stripes:
      return wave(x);
    case Pattern::checks:
      return wave(x) * wave(y);
    case Pattern::spots: {
      const double away = std::hypot(x - std::floor(x) - 0.5, y - std::floor(y) - 0.5);
      return std::clamp(10.0 * (0.25 - away), -1.0, 1.0);
    }
    case Pattern::none:
      break;
  }
  return 0.0;
}

cv::Mat renderWall(const CameraRays& rays, const Eigen::Isometry3d& room_T_world, const RoomWall& wall) {
  cv::Mat image(rays.height_px(), rays.width_px(), CV_32F);
  const Eigen::Vector3d eye = room_T_world * rays.origin_mm();
  const double cosine = std::cos(wall.turn_deg * kRadPerDeg), sine = std::sin(wall.turn_deg * kRadPerDeg);
  parallelRanges(0, image.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < image.cols; ++x) {
        const Eigen::Vector3d along = room_T_world.linear() * rays.direction(x, y);
        const Eigen::Vector3d p_mm = eye + (wall.distance_mm - eye.z()) / along.z() * along;
        const float structure = 0.05f * sharedNoise().at(p_mm, 160.0) + 0.015f * sharedNoise().at(p_mm, 30.0);
        double light = std::max(0.02f, 0.16f + structure + float(0.00004 * p_mm.x()));
        if (wall.pattern != Pattern::none)
          light *= 1.0 + wall.pattern_contrast * patternAt(wall.pattern, wall.pattern_mm,
                                                           cosine * p_mm.x() + sine * p_mm.y(),
                                                           cosine * p_mm.y() - sine * p_mm.x());
        for (const RoomWindow& window : wall.windows)
          if (p_mm.x() > window.low_mm.x() && p_mm.x() < window.high_mm.x() && p_mm.y() > window.low_mm.y() &&
              p_mm.y() < window.high_mm.y())
            light = window.radiance;
        image.at<float>(y, x) = float(light);
      }
  });
  return image;
}

}  // namespace facenav::room
