#pragma once
// A closed ball about the origin, mm, with normals.

#include <cmath>

#include "facenav/surface/triangle_mesh.h"

namespace facenav::testing {

inline surface::TriangleMesh ballMesh(double radius_mm, int rows = 30, int columns = 40) {
  surface::TriangleMesh mesh;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const double phi = M_PI * i / (rows - 1), theta = 2 * M_PI * j / (columns - 1);
      const Eigen::Vector3d d(std::sin(phi) * std::cos(theta), std::sin(phi) * std::sin(theta),
                              std::cos(phi));
      mesh.vertices_mm.push_back(radius_mm * d);
      mesh.normals.push_back(d);
    }
  for (int i = 0; i + 1 < rows; ++i)
    for (int j = 0; j + 1 < columns; ++j) {
      const int a = i * columns + j;
      mesh.triangles.emplace_back(a, a + columns, a + 1);
      mesh.triangles.emplace_back(a + 1, a + columns, a + columns + 1);
    }
  return mesh;
}

}  // namespace facenav::testing
