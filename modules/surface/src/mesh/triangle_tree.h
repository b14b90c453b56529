#pragma once
// A tree of boxes over a mesh's triangles: the nearest place of the mesh, also from far away (VTK's cell
// locator searches shell after shell of empty buckets there and takes milliseconds).

#include <optional>
#include <vector>

#include "facenav/surface/triangle_mesh.h"

namespace facenav::surface {

struct NearestPlace {
  Eigen::Vector3f point_mm = Eigen::Vector3f::Zero();
  float squared_mm2 = 0;
  int triangle = -1;
};

/// Keeps its own copy (float) of the mesh. Safe to ask from several threads.
class TriangleTree {
 public:
  explicit TriangleTree(const TriangleMesh& mesh);

  /// `near`: a triangle that is probably close (the answer for a neighbour), which shortens the search.
  /// Where several triangles share the nearest place (an edge, a corner), the one that faces the
  /// point most is named: its side tells inside from outside.
  NearestPlace nearest(const Eigen::Vector3f& p_mm, std::optional<int> near = {}) const;

 private:
  struct Node {
    Eigen::Array4f low, high;  // the fourth is 0: four numbers are one register
    int first = 0, count = 0;  // triangles of a leaf; count 0: children at first and first + 1
  };
  struct Corners {
    Eigen::Vector3f a, b, c;
  };
  void split(int node, std::vector<Eigen::Vector3f>& middle);
  /// How squarely the slot's triangle faces p, seen from its place `at`.
  float facing(int slot, const Eigen::Vector3f& p, const Eigen::Vector3f& at) const;
  void visit(int node, const Eigen::Array4f& p, NearestPlace& best, float& best_facing) const;
  void consider(int slot, const Eigen::Vector3f& p, NearestPlace& best, float& best_facing) const;

  std::vector<Corners> corners_;  // in the order of the leaves
  std::vector<int> triangle_;     // of each slot
  std::vector<int> slot_;         // of each triangle
  std::vector<Node> nodes_;
};

}  // namespace facenav::surface
