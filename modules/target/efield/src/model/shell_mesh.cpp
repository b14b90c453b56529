#include "facenav/efield/shell_mesh.h"

#include <Eigen/Geometry>
#include <array>
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

/// Numbers of vertices by their place: those on an edge belong to several faces.
class SphereNet {
 public:
  /// Number of the vertex on the unit sphere in this direction.
  int vertex(const Vector3d& direction) {
    const Vector3d place = direction.normalized();
    constexpr double kParts = 1e6;  // of a length of 1; vertices lie much farther apart
    const std::array<long, 3> key = {std::lround(kParts * place.x()), std::lround(kParts * place.y()),
                                     std::lround(kParts * place.z())};
    const auto [found, is_new] = numbers_.try_emplace(key, int(vertices_.size()));
    if (is_new) vertices_.push_back(place);
    return found->second;
  }
  void addTriangle(int a, int b, int c) { triangles_.emplace_back(a, b, c); }
  ShellMesh mesh() const {
    ShellMesh mesh{Eigen::Matrix3Xd(3, Eigen::Index(vertices_.size())),
                   Eigen::Matrix3Xi(3, Eigen::Index(triangles_.size()))};
    for (std::size_t i = 0; i < vertices_.size(); ++i) mesh.vertices_mm.col(Eigen::Index(i)) = vertices_[i];
    for (std::size_t t = 0; t < triangles_.size(); ++t) mesh.triangles.col(Eigen::Index(t)) = triangles_[t];
    return mesh;
  }

 private:
  std::map<std::array<long, 3>, int> numbers_;
  std::vector<Vector3d> vertices_;
  std::vector<Vector3i> triangles_;
};

/// Moves the vertices of a unit sphere towards its top: stereographic projection from the lowest point,
/// scaling of the plane, and back.
void grade(ShellMesh& mesh, double upper_scale) {
  if (upper_scale == 1.0) return;
  const double square = upper_scale * upper_scale;
  for (auto vertex : mesh.vertices_mm.colwise()) {
    const double up = 1 + vertex.z(), down = 1 - vertex.z(), sum = up + square * down;
    const double z = (up - square * down) / sum;
    vertex.head<2>() *= 2 * upper_scale / sum;
    vertex.z() = z;
    vertex.normalize();
  }
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
  grade(mesh, upper_scale);
  return mesh;
}

ShellMesh geodesicSphere(int parts, double upper_scale) {
  FACENAV_EXPECT(parts > 0, "edges in pieces");
  const ShellMesh coarse = icosahedron();
  SphereNet net;
  for (const auto face : coarse.triangles.colwise()) {
    const Vector3d a = coarse.vertices_mm.col(face[0]), b = coarse.vertices_mm.col(face[1]),
                   c = coarse.vertices_mm.col(face[2]);
    const double edge_rad = std::acos(a.dot(b));
    // Sines in place of the shares themselves cut each edge into equal angles.
    const auto at = [&](int i, int j) {
      const auto share = [&](int count) { return std::sin(edge_rad * count / parts); };
      return net.vertex(share(parts - i - j) * a + share(i) * b + share(j) * c);
    };
    for (int i = 0; i < parts; ++i)
      for (int j = 0; i + j < parts; ++j) {
        net.addTriangle(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j + 1 < parts) net.addTriangle(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }
  ShellMesh mesh = net.mesh();
  grade(mesh, upper_scale);
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
