#include "edge_profile.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "square_homography.h"

namespace facenav::tracking {

std::optional<EdgePoint> locateEdge(const cv::Mat& grey, const Eigen::Vector2d& at,
                                    const Eigen::Vector2d& into_black, double half_px,
                                    double least_contrast) {
  constexpr int kMost = 12;
  const int half = std::min(kMost, int(std::ceil(half_px / 0.5)));
  const double step_px = half_px / half;
  const Eigen::Vector2d first = at - half_px * into_black, last = at + half_px * into_black;
  if (!isInside(grey, first.x(), first.y()) || !isInside(grey, last.x(), last.y())) return std::nullopt;
  std::array<double, 2 * kMost + 1> values{};
  for (int k = -half; k <= half; ++k)
    values[k + half] =
        bilinear(grey, at.x() + k * step_px * into_black.x(), at.y() + k * step_px * into_black.y());
  const double contrast = values[0] - values[2 * half];
  if (contrast < least_contrast) return std::nullopt;
  double moment = 0;
  for (int k = -half; k < half; ++k) moment += (values[k + half] - values[k + half + 1]) * (k + 0.5);
  const double offset_px = moment / contrast * step_px;
  if (std::abs(offset_px) > 0.8 * half_px) return std::nullopt;
  return EdgePoint{offset_px, contrast};
}

}  // namespace facenav::tracking
