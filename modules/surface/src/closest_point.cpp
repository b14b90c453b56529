#include "facenav/surface/closest_point.h"

#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <Eigen/Geometry>
#include <cmath>

#include "facenav/core/error.h"
#include "mesh_polydata.h"

namespace facenav::surface {

struct ClosestPoint::Tree {
  vtkSmartPointer<vtkPolyData> poly_data;
  vtkNew<vtkStaticCellLocator> locator;
  std::vector<Eigen::Vector3d> normals;  // one per triangle
};

ClosestPoint::ClosestPoint(const TriangleMesh& mesh) : tree_(std::make_unique<Tree>()) {
  if (mesh.triangles.empty()) throw Error("a surface without triangles has no nearest point");
  tree_->poly_data = toPolyData(mesh);
  tree_->locator->SetDataSet(tree_->poly_data);
  tree_->locator->BuildLocator();
  for (const auto& t : mesh.triangles) {
    const auto& a = mesh.vertices_mm[t[0]];
    tree_->normals.push_back((mesh.vertices_mm[t[1]] - a).cross(mesh.vertices_mm[t[2]] - a).normalized());
  }
}

ClosestPoint::~ClosestPoint() = default;
ClosestPoint::ClosestPoint(ClosestPoint&&) noexcept = default;
ClosestPoint& ClosestPoint::operator=(ClosestPoint&&) noexcept = default;

SurfacePoint ClosestPoint::nearest(const Point<Mri>& p) const {
  vtkNew<vtkGenericCell> cell;
  double found[3], squared = 0;
  vtkIdType id = -1;
  int sub_id = 0;
  tree_->locator->FindClosestPoint(p.mm.data(), found, cell, id, sub_id, squared);
  FACENAV_EXPECT(id >= 0, "a mesh with triangles has a nearest one");
  SurfacePoint out;
  out.point = Point<Mri>(found[0], found[1], found[2]);
  out.normal = Direction<Mri>(tree_->normals[id]);
  out.distance_mm = std::sqrt(squared);
  out.is_outside = (p.mm - out.point.mm).dot(out.normal.v) >= 0;
  out.triangle = int(id);
  return out;
}

}  // namespace facenav::surface
