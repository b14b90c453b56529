#pragma once
// A tree of boxes over a mesh's triangles: finds the nearest place of the mesh, also from far away. From far
// away, VTK's cell locator searches shell after shell of empty buckets and takes milliseconds.

#include <optional>
#include <vector>

#include "facenav/surface/triangle_mesh.h"

namespace facenav::surface {

struct NearestPlace {
  Eigen::Vector3f point_mm = Eigen::Vector3f::Zero();
  float squared_mm2 = 0;
  int triangle = -1;
};

/// Builds the tree on its own copy (float) of the mesh. Thread-safe.
class TriangleTree {
 public:
  explicit TriangleTree(const TriangleMesh& mesh);

  /// Finds the nearest place. `near`: a triangle that is probably close (the result for a neighbour); it
  /// shortens the search. When several triangles share the nearest place (an edge, a corner), the result is
  /// the one that faces the point most: its side decides between inside and outside.
  NearestPlace nearest(const Eigen::Vector3f& p_mm, std::optional<int> near = {}) const;

 private:
  struct Node {
    Eigen::Array4f low, high;  // the fourth is 0: four numbers fill one register
    int first = 0, count = 0;  // triangles of a leaf; count 0: children at first and first + 1
  };
  struct Corners {
    Eigen::Vector3f a, b, c;
  };
  void split(int node, std::vector<Eigen::Vector3f>& middle);
  /// Measure of how squarely the slot's triangle faces p; `at`: its nearest place.
  float facing(int slot, const Eigen::Vector3f& p, const Eigen::Vector3f& at) const;
  void visit(int node, const Eigen::Array4f& p, NearestPlace& best, float& best_facing) const;
  void consider(int slot, const Eigen::Vector3f& p, NearestPlace& best, float& best_facing) const;

  std::vector<Corners> corners_;  // corners in the order of the leaves
  std::vector<int> triangle_;     // index of each slot's triangle
  std::vector<int> slot_;         // slot of each triangle
  std::vector<Node> nodes_;
};

}  // namespace facenav::surface
