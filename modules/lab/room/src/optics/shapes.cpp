#include "shapes.h"
#include "facenav/geometry/normal_equations.h"

#include <cmath>

namespace facenav::room {
namespace {

void addFacet(surface::TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& corners_mm) {
  const int first = int(mesh.vertices_mm.size());
  const Eigen::Vector3d normal =
      (corners_mm[1] - corners_mm[0]).cross(corners_mm[2] - corners_mm[0]).normalized();
  for (const auto& corner : corners_mm) {
    mesh.vertices_mm.push_back(corner);
    mesh.normals.push_back(normal);
  }
  for (int i = 1; i + 1 < int(corners_mm.size()); ++i)
    mesh.triangles.emplace_back(first, first + i, first + i + 1);
}

}  // namespace

surface::TriangleMesh box(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  surface::TriangleMesh mesh;
  const auto corner = [&](int x, int y, int z) {
    return Eigen::Vector3d(x ? b.x() : a.x(), y ? b.y() : a.y(), z ? b.z() : a.z());
  };
  addFacet(mesh, {corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0)});
  addFacet(mesh, {corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1)});
  addFacet(mesh, {corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1)});
  addFacet(mesh, {corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0)});
  addFacet(mesh, {corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0)});
  addFacet(mesh, {corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1)});
  return mesh;
}

surface::TriangleMesh cylinder(const Eigen::Vector2d& centre_mm, double radius_mm, double z0_mm,
                               double z1_mm) {
  constexpr int kSides = 64;
  surface::TriangleMesh mesh;
  std::vector<Eigen::Vector3d> bottom, top;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * M_PI * i / kSides;
    const Eigen::Vector2d p = centre_mm + radius_mm * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    top.emplace_back(p.x(), p.y(), z1_mm);
    bottom.emplace_back(p.x(), p.y(), z0_mm);
  }
  for (int i = 0; i < kSides; ++i) {
    const int j = (i + 1) % kSides;
    addFacet(mesh, {bottom[i], bottom[j], top[j], top[i]});
  }
  addFacet(mesh, top);
  addFacet(mesh, std::vector<Eigen::Vector3d>(bottom.rbegin(), bottom.rend()));
  return mesh;
}

surface::TriangleMesh ellipsoid(const Eigen::Vector3d& centre_mm, const Eigen::Vector3d& radii_mm,
                                int rings) {
  surface::TriangleMesh mesh;
  const int sides = 2 * rings;
  for (int r = 0; r <= rings; ++r)
    for (int s = 0; s < sides; ++s) {
      const double polar = M_PI * r / rings, angle = 2 * M_PI * s / sides;
      const Eigen::Vector3d unit(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle),
                                 std::cos(polar));
      mesh.vertices_mm.push_back(centre_mm + radii_mm.cwiseProduct(unit));
      mesh.normals.push_back(unit.cwiseQuotient(radii_mm).normalized());
    }
  for (int r = 0; r < rings; ++r)
    for (int s = 0; s < sides; ++s) {
      const int a = r * sides + s, b = r * sides + (s + 1) % sides, c = a + sides, d = b + sides;
      if (r > 0) mesh.triangles.emplace_back(a, c, b);
      if (r + 1 < rings) mesh.triangles.emplace_back(b, c, d);
    }
  return mesh;
}

surface::TriangleMesh bar(const Eigen::Vector3d& from_mm, const Eigen::Vector3d& to_mm, double width_mm) {
  const double half = 0.5 * width_mm, length = (to_mm - from_mm).norm();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotationBetween(Eigen::Vector3d::UnitZ(), to_mm - from_mm).toRotationMatrix();
  pose.translation() = from_mm;
  return moved(pose, box({-half, -half, 0.0}, {half, half, length}));
}

surface::TriangleMesh joined(const surface::TriangleMesh& a, const surface::TriangleMesh& b) {
  surface::TriangleMesh both = a;
  const Eigen::Vector3i shift = Eigen::Vector3i::Constant(int(a.vertices_mm.size()));
  both.vertices_mm.insert(both.vertices_mm.end(), b.vertices_mm.begin(), b.vertices_mm.end());
  both.normals.insert(both.normals.end(), b.normals.begin(), b.normals.end());
  for (const auto& triangle : b.triangles) both.triangles.push_back(triangle + shift);
  return both;
}

surface::TriangleMesh moved(const Eigen::Isometry3d& pose, surface::TriangleMesh mesh) {
  for (auto& p : mesh.vertices_mm) p = pose * p;
  for (auto& n : mesh.normals) n = pose.linear() * n;
  return mesh;
}

}  // namespace facenav::room
