#include "facenav/surface/closest_point.h"

#include <Eigen/Geometry>
#include <cmath>

#include "facenav/core/error.h"
#include "triangle_tree.h"

namespace facenav::surface {

struct ClosestPoint::Tree {
  TriangleTree boxes;
  std::vector<Eigen::Vector3d> normals;  // one per triangle
};

ClosestPoint::ClosestPoint(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw Error("a surface without triangles has no nearest point");
  tree_ = std::make_unique<Tree>(Tree{TriangleTree(mesh), {}});
  for (const auto& t : mesh.triangles) {
    const auto& a = mesh.vertices_mm[t[0]];
    tree_->normals.push_back((mesh.vertices_mm[t[1]] - a).cross(mesh.vertices_mm[t[2]] - a).normalized());
  }
}

ClosestPoint::~ClosestPoint() = default;
ClosestPoint::ClosestPoint(ClosestPoint&&) noexcept = default;
ClosestPoint& ClosestPoint::operator=(ClosestPoint&&) noexcept = default;

SurfacePoint ClosestPoint::nearest(const Point<Mri>& p, std::optional<int> near) const {
  const NearestPlace found = tree_->boxes.nearest(p.mm.cast<float>(), near);
  FACENAV_EXPECT(found.triangle >= 0, "a mesh with triangles has a nearest one");
  SurfacePoint out;
  out.point = Point<Mri>(found.point_mm.cast<double>());
  out.normal = Direction<Mri>(tree_->normals[std::size_t(found.triangle)]);
  out.distance_mm = (p.mm - out.point.mm).norm();
  out.is_outside = (p.mm - out.point.mm).dot(out.normal.v) >= 0;
  out.triangle = found.triangle;
  return out;
}

}  // namespace facenav::surface
