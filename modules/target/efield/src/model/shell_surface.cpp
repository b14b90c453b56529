#include "model/shell_surface.h"

namespace facenav::efield {

surface::TriangleMesh triangleMesh(const ShellMesh& shell) {
  surface::TriangleMesh mesh;
  for (const auto vertex : shell.vertices_mm.colwise()) mesh.vertices_mm.emplace_back(vertex);
  const Eigen::Matrix3Xd areas = vertexAreas_mm2(shell);
  for (const auto area : areas.colwise()) mesh.normals.push_back(area.normalized());
  for (const auto triangle : shell.triangles.colwise()) mesh.triangles.emplace_back(triangle);
  return mesh;
}

}  // namespace facenav::efield
