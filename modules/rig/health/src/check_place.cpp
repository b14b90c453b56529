#include "check_place.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "facenav/geometry/rotation.h"

namespace facenav::health {

CheckPlace placeOf(const SingleView& view, const cameras::Board& board) {
  const Eigen::Vector3d middle_mm(0.5 * (board.columns - 1) * board.square_mm,
                                  0.5 * (board.rows - 1) * board.square_mm, 0);
  return {view.camera_T_board * middle_mm, view.camera_T_board.linear().col(2)};
}

CheckPlace placeOf(const SquareObservation& marker, const cameras::StereoRig& rig) {
  std::array<Eigen::Vector3d, 4> corners;
  Eigen::Vector3d middle_mm = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = cameras::triangulate(rig, marker.left_px[i], marker.right_px[i]).mm;
    middle_mm += corners[i] / 4.0;
  }
  return {middle_mm, (corners[2] - corners[0]).cross(corners[3] - corners[1]).normalized()};
}

CheckMotion motionBetween(const CheckPlace& a, const CheckPlace& b) {
  const double moved_mm = (b.middle_mm - a.middle_mm).norm();
  if (!std::isfinite(moved_mm)) return {};  // corners that cannot be triangulated
  return {moved_mm, std::acos(std::clamp(a.normal.dot(b.normal), -1.0, 1.0)) * kDegPerRad};
}

}  // namespace facenav::health
