#pragma once
// TriangleMesh: vertices in Mri mm, outward-facing triangles (counter-clockwise seen from outside).

#include <Eigen/Core>
#include <vector>

#include "facenav/geometry/point.h"

namespace facenav::surface {

struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices_mm;
  std::vector<Eigen::Vector3d> normals;  // unit, outward, one per vertex
  std::vector<Eigen::Vector3i> triangles;
};

}  // namespace facenav::surface
