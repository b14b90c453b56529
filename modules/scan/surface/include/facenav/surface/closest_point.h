#pragma once
// The nearest place on a surface: cortex under a scalp point, distance of a target from the scalp.

#include <memory>
#include <optional>

#include "facenav/surface/triangle_mesh.h"

namespace facenav::surface {

struct SurfacePoint {
  Point<Mri> point;
  Direction<Mri> normal;   // outward, of the triangle
  double distance_mm = 0;  // never negative
  bool is_outside = true;  // the given point lies on the outer side of that triangle
  int triangle = -1;
};

/// A search tree over one mesh; the mesh need not outlive it. Thread-safe.
class ClosestPoint {
 public:
  /// Throws Error for a mesh without triangles.
  explicit ClosestPoint(const TriangleMesh& mesh);
  ~ClosestPoint();
  ClosestPoint(ClosestPoint&&) noexcept;
  ClosestPoint& operator=(ClosestPoint&&) noexcept;

  /// Nearest place of the mesh. `near`: a triangle that is probably close, such as the result for a
  /// neighbour; it only saves time.
  SurfacePoint nearest(const Point<Mri>& p, std::optional<int> near = {}) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace facenav::surface
