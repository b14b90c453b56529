#pragma once
// Point<F> (mm), Direction<F> (unit length) and PointCloud<F>: coordinates with their frame as a type. A
// point of one frame cannot be passed to code that expects another.

#include <Eigen/Core>
#include <vector>

#include "facenav/geometry/frames.h"

namespace facenav {
inline namespace geometry {

template <class Frame>
struct Point {
  Eigen::Vector3d mm = Eigen::Vector3d::Zero();

  Point() = default;
  Point(double x_mm, double y_mm, double z_mm) : mm(x_mm, y_mm, z_mm) {}
  explicit Point(const Eigen::Vector3d& p_mm) : mm(p_mm) {}
};

template <class Frame>
struct Direction {
  Eigen::Vector3d v = Eigen::Vector3d::UnitZ();

  Direction() = default;
  /// Normalised on construction.
  explicit Direction(const Eigen::Vector3d& direction) : v(direction.normalized()) {}
};

/// Points in mm; normals (unit, outward) either empty or one per point.
template <class Frame>
struct PointCloud {
  std::vector<Eigen::Vector3d> points_mm;
  std::vector<Eigen::Vector3d> normals;

  std::size_t size() const { return points_mm.size(); }
  bool empty() const { return points_mm.empty(); }
};

}  // namespace geometry
}  // namespace facenav
