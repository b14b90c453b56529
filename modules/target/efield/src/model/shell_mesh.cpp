#include "facenav/efield/shell_mesh.h"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "facenav/core/error.h"

namespace facenav::efield {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

ShellMesh icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  const double corners[12][3] = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                 {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  const int faces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                            {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                            {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                            {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  ShellMesh mesh{Eigen::Matrix3Xd(3, 12), Eigen::Matrix3Xi(3, 20)};
  for (int i = 0; i < 12; ++i) mesh.vertices_mm.col(i) = Vector3d(corners[i]).normalized();
  for (int t = 0; t < 20; ++t) mesh.triangles.col(t) = Vector3i(faces[t]);
  return mesh;
}

/// Each triangle becomes four; new vertices lie on the unit sphere, after the old ones.
ShellMesh divided(const ShellMesh& coarse) {
  std::vector<Vector3d> vertices;
  for (const auto vertex : coarse.vertices_mm.colwise()) vertices.emplace_back(vertex);
  std::map<std::pair<int, int>, int> middles;
  const auto middleOf = [&](int a, int b) {
    const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), int(vertices.size()));
    if (is_new) vertices.push_back((vertices[std::size_t(a)] + vertices[std::size_t(b)]).normalized());
    return place->second;
  };
  ShellMesh fine;
  fine.triangles.resize(3, 4 * coarse.triangles.cols());
  for (Eigen::Index t = 0; t < coarse.triangles.cols(); ++t) {
    const Vector3i v = coarse.triangles.col(t);
    const Vector3i m(middleOf(v[0], v[1]), middleOf(v[1], v[2]), middleOf(v[2], v[0]));
    fine.triangles.middleCols<4>(4 * t) << v[0], v[1], v[2], m[0], m[0], m[1], m[2], m[1], m[2], m[0], m[1],
        m[2];
  }
  fine.vertices_mm.resize(3, Eigen::Index(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i) fine.vertices_mm.col(Eigen::Index(i)) = vertices[i];
  return fine;
}

/// Calls visit(corner numbers, area vector) for each triangle.
template <class Visit>
void forTriangles(const ShellMesh& mesh, Visit&& visit) {
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Vector3i v = mesh.triangles.col(t);
    const Vector3d a = mesh.vertices_mm.col(v[0]), b = mesh.vertices_mm.col(v[1]),
                   c = mesh.vertices_mm.col(v[2]);
    visit(v, Vector3d(0.5 * (b - a).cross(c - a)));
  }
}

}  // namespace

ShellMesh icosphere(int divisions, double upper_scale) {
  ShellMesh mesh = icosahedron();
  for (int i = 0; i < divisions; ++i) mesh = divided(mesh);
  if (upper_scale == 1.0) return mesh;
  // Stereographic projection from the lowest point, scaling of the plane, and back.
  const double square = upper_scale * upper_scale;
  for (auto vertex : mesh.vertices_mm.colwise()) {
    const double up = 1 + vertex.z(), down = 1 - vertex.z(), sum = up + square * down;
    const double z = (up - square * down) / sum;
    vertex.head<2>() *= 2 * upper_scale / sum;
    vertex.z() = z;
    vertex.normalize();
  }
  return mesh;
}

Eigen::Matrix3Xd vertexAreas_mm2(const ShellMesh& mesh) {
  Eigen::Matrix3Xd areas = Eigen::Matrix3Xd::Zero(3, mesh.vertices_mm.cols());
  forTriangles(mesh, [&](const Vector3i& v, const Vector3d& area) {
    for (int c = 0; c < 3; ++c) areas.col(v[c]) += area / 3;
  });
  return areas;
}

Eigen::VectorXd vertexEdges_mm(const ShellMesh& mesh) {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(mesh.vertices_mm.cols()), counts = sums;
  forTriangles(mesh, [&](const Vector3i& v, const Vector3d&) {
    for (int c = 0; c < 3; ++c) {
      sums[v[c]] += (mesh.vertices_mm.col(v[c]) - mesh.vertices_mm.col(v[(c + 1) % 3])).norm();
      counts[v[c]] += 1;
    }
  });
  return sums.cwiseQuotient(counts.cwiseMax(1));
}

double volumeWithin_mm3(const ShellMesh& mesh) {
  double volume = 0;
  forTriangles(mesh, [&](const Vector3i& v, const Vector3d& area) {
    volume += mesh.vertices_mm.col(v[0]).dot(area) / 3;
  });
  return volume;
}

void requireClosed(const ShellMesh& mesh, const std::string& name) {
  std::set<std::pair<int, int>> open;
  forTriangles(mesh, [&](const Vector3i& v, const Vector3d&) {
    for (int c = 0; c < 3; ++c) {
      const int a = v[c], b = v[(c + 1) % 3];
      if (!open.erase({b, a})) open.insert({a, b});
    }
  });
  if (mesh.triangles.cols() == 0 || !open.empty())
    throw Error("the surface '" + name + "' is not closed", {}, "the electric field needs a closed one");
  if (volumeWithin_mm3(mesh) <= 0)
    throw Error("the triangles of the surface '" + name + "' face inwards", {}, "reverse their corners");
}

}  // namespace facenav::efield
