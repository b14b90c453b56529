#pragma once
// Lengths along the scalp, as with a tape: geodesics, and the tapes of the 10-20 system, which are held in a
// plane. All points Mri, mm.
// - A geodesic is the shortest way between two points that stays on the skin. It is found as a taut chain:
//   Dijkstra's way along the mesh's edges is the start; then each point moves to the middle of its neighbours
//   and back onto the skin, with twice as many points in each round, until they are about 2 mm apart. On a
//   sphere of 90 mm its length is right within 0.1 % (tested; the guaranteed bound is 0.5 %).
// - A tape is pulled tight: it spans hollows (temple, nape, the root of the nose) in the air. In its plane it
//   is the convex hull of the skin's outline between its ends.

#include <memory>
#include <vector>

#include "facenav/surface/closest_point.h"

namespace facenav::surface {

/// A line of straight pieces.
class ScalpPath {
 public:
  /// At least two points.
  explicit ScalpPath(std::vector<Eigen::Vector3d> points_mm);

  const std::vector<Eigen::Vector3d>& points_mm() const { return points_mm_; }
  double length_mm() const { return from_start_mm_.back(); }
  /// The point at this distance from the start along the line; the ends beyond them.
  Eigen::Vector3d at(double distance_mm) const;
  Eigen::Vector3d atFraction(double fraction) const { return at(fraction * length_mm()); }
  /// Unit direction of the piece at this distance, away from the start.
  Eigen::Vector3d direction(double distance_mm) const;

 private:
  std::size_t pieceAt(double distance_mm) const;

  std::vector<Eigen::Vector3d> points_mm_;
  std::vector<double> from_start_mm_;  // distance of each point along the line
};

/// Measures along one mesh. Thread-safe.
class ScalpPaths {
 public:
  /// Throws Error for a mesh without triangles.
  explicit ScalpPaths(const TriangleMesh& mesh);

  /// The place of the skin nearest to a point.
  SurfacePoint onSkin(const Eigen::Vector3d& p_mm) const { return skin_.nearest(Point<Mri>(p_mm)); }
  /// Geodesic between the places of the skin nearest to both points. Throws Error where the skin has a gap
  /// between them.
  ScalpPath shortest(const Eigen::Vector3d& from_mm, const Eigen::Vector3d& to_mm) const;
  /// A tape from `from_mm` to `to_mm`, held in the plane through `over_mm`, on the side of `over_mm`. Throws
  /// Error when the three lie on one line, or the plane meets no skin there.
  ScalpPath tape(const Eigen::Vector3d& from_mm, const Eigen::Vector3d& over_mm,
                 const Eigen::Vector3d& to_mm) const;
  /// A tape laid straight ahead from a place, `length_mm` long: in the plane of `ahead` and `outwards`, the
  /// skin's normal there. It starts over the place where that lies in a hollow. Throws Error where the skin
  /// ends before.
  ScalpPath straight(const Eigen::Vector3d& from_mm, const Eigen::Vector3d& ahead,
                     const Eigen::Vector3d& outwards, double length_mm) const;

 private:
  std::vector<int> alongEdges(int from, int to) const;

  TriangleMesh mesh_;
  ClosestPoint skin_;
  std::vector<int> first_;  // first neighbour of each vertex in neighbour_; one more at the end
  std::vector<int> neighbour_;
};

}  // namespace facenav::surface
