#pragma once
// NearestSkin: the exact point of the skin nearest to a given point. A grid stores the nearest vertex of each
// node, filled once by vector propagation (Danielsson 1980). A query starts at its node's vertex, walks over
// the mesh to the nearest vertex, and projects onto the triangles around it. Mri mm throughout.

#include <array>
#include <vector>

#include "facenav/core/grouped.h"
#include "facenav/registration/skin_model.h"

namespace facenav::registration {

struct SkinContact {
  double distance_mm = 0.0;  // to the nearest point of the surface; positive outside
  Eigen::Vector3d normal;    // unit, outward, interpolated over the triangle
  Eigen::Vector3d closest_mm;
  int vertex = -1;
  bool is_on_border = false;    // the nearest skin is the scan's cut edge: no counterpart
  bool is_beyond_scan = false;  // the point lies outside the field of view
};

class NearestSkin {
 public:
  static constexpr double kMargin_mm = 45.0;  // margin of the grid around the skin

  /// Keeps a reference to `skin`, which must outlive it. Throws Error if it has no points, no normals or no
  /// triangles.
  explicit NearestSkin(const SkinModel& skin);

  /// Contact with the nearest triangle around the nearest vertex.
  SkinContact nearest(const Eigen::Vector3d& p_mri_mm) const;
  int nearestVertex(const Eigen::Vector3d& p_mri_mm) const;
  bool isOnBorder(int vertex) const { return on_border_[vertex]; }
  bool isBeyondScan(const Eigen::Vector3d& p_mri_mm) const;

  const Eigen::Vector3d& low_mm() const { return low_; }
  const Eigen::Vector3d& high_mm() const { return high_; }

 private:
  const std::vector<Eigen::Vector3d>& vertices() const { return skin_->points.points_mm; }
  const std::vector<Eigen::Vector3d>& normals() const { return skin_->points.normals; }
  int nodeVertex(const Eigen::Vector3d& p) const;
  void linkVertices();
  void fillNodes();
  void propagate(const std::vector<std::array<int, 3>>& offsets, bool is_backward);

  const SkinModel* skin_;
  Grouped neighbours_;        // neighbours of each vertex
  Grouped corner_triangles_;  // triangles around each vertex
  std::vector<bool> on_border_;
  Eigen::Vector3d low_, high_, origin_;
  std::array<int, 3> size_{};
  std::vector<int> node_;  // nearest vertex of each node
};

}  // namespace facenav::registration
