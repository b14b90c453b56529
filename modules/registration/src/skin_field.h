#pragma once
// SkinField: where is the skin nearest to a point? A grid holds the nearest vertex of each node, filled once
// by vector propagation (Danielsson 1980); a query takes its node's vertex, walks to the nearest one over the
// mesh, and then drops the perpendicular onto the triangles around it. No search tree; Mri mm throughout.

#include <array>
#include <vector>

#include "facenav/registration/aligner.h"

namespace facenav::registration {

struct SkinContact {
  double distance_mm = 0.0;  // along the normal, positive outside
  Eigen::Vector3d normal;    // unit, outward, interpolated over the triangle
  Eigen::Vector3d closest_mm;
  int vertex = -1;
  bool is_on_border = false;    // the nearest skin is where the scan cuts it: no counterpart
  bool is_beyond_scan = false;  // the point lies outside the field of view
};

class SkinField {
 public:
  /// Throws Error when the skin has no points, no normals or no triangles.
  explicit SkinField(const SkinModel& skin);

  /// Distance to the tangent plane of the nearest vertex: fast, for coarse stages.
  SkinContact nearestVertex(const Eigen::Vector3d& p_mri_mm) const;
  /// Distance to the nearest triangle around the nearest vertex, with its interpolated normal.
  SkinContact nearestSkin(const Eigen::Vector3d& p_mri_mm) const;

  /// Signed distance at the nearest node of the grid, mm: a look-up, good to about 2 mm. kNoSkin outside the
  /// grid and beyond the scan's end.
  float roughDistance_mm(const Eigen::Vector3d& p_mri_mm) const;
  static constexpr float kNoSkin = 1e6f;

  const std::vector<Eigen::Vector3d>& vertices() const { return skin_.points.points_mm; }
  const std::vector<Eigen::Vector3d>& normals() const { return skin_.points.normals; }
  const Eigen::Vector3d& low() const { return low_; }
  const Eigen::Vector3d& high() const { return high_; }

 private:
  int walk(int vertex, const Eigen::Vector3d& p) const;
  int nodeVertex(const Eigen::Vector3d& p) const;
  bool isBeyondScan(const Eigen::Vector3d& p) const;
  void linkVertices();
  void fillNodes();
  void measureNodes();
  void propagate(const std::vector<std::array<int, 3>>& offsets, bool is_backward);

  SkinModel skin_;
  std::vector<int> first_neighbour_, neighbours_;
  std::vector<int> first_triangle_, triangles_of_;
  std::vector<bool> on_border_;
  Eigen::Vector3d low_, high_, origin_;
  std::array<int, 3> size_{};
  std::vector<int> node_;           // nearest vertex
  std::vector<float> distance_mm_;  // signed, at the node
};

}  // namespace facenav::registration
