#include "coil_surroundings.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace facenav::coil_tracking {
namespace {

/// The whole pixels between the corners, within the picture.
cv::Rect boxOf(const std::array<Eigen::Vector2d, 4>& corners_px, cv::Size size) {
  Eigen::Vector2d low = corners_px[0], high = corners_px[0];
  for (const Eigen::Vector2d& corner : corners_px) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
  if (!low.allFinite() || !high.allFinite()) return {};
  const cv::Rect2d box(low.x(), low.y(), high.x() - low.x(), high.y() - low.y());
  const cv::Rect2d inside = box & cv::Rect2d(0, 0, size.width, size.height);
  return {int(inside.x), int(inside.y), int(inside.width), int(inside.height)};
}

bool isEqual(const cv::Mat& a, const cv::Mat& b) {
  for (int row = 0; row < a.rows; ++row)
    if (std::memcmp(a.ptr(row), b.ptr(row), std::size_t(a.cols)) != 0) return false;
  return true;
}

}  // namespace

CoilSurroundings::CoilSurroundings(const cameras::StereoFrame& frame, const health::SquareObservation& marker)
    : places_{boxOf(marker.left_px, frame.left.size()), boxOf(marker.right_px, frame.right.size())},
      pictures_{frame.left(places_[0]).clone(), frame.right(places_[1]).clone()} {}

bool CoilSurroundings::isRepeatedIn(const cameras::StereoFrame& frame) const {
  const std::array<const cv::Mat*, 2> now{&frame.left, &frame.right};
  for (std::size_t side = 0; side < 2; ++side) {
    const cv::Rect& place = places_[side];
    if (place.empty() || (place & cv::Rect({}, now[side]->size())) != place) continue;
    if (isEqual(pictures_[side], (*now[side])(place))) return true;
  }
  return false;
}

}  // namespace facenav::coil_tracking
