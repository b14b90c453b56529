#include "plate_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facenav::guidance {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kReach_mm = 60;  // below the highest skin: no plate reaches further round the head

OverPlate over(const Vector3d& p_mm, const Matrix3d& axes, const Vector3d& pivot_mm) {
  const Vector3d in_coil = axes.transpose() * (p_mm - pivot_mm);
  return {in_coil.x(), in_coil.y(), -in_coil.z()};
}

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

using Triangle = std::array<OverPlate, 3>;

/// Height of the triangle's plane at `at`, if that lies in the triangle (seen along the axis).
std::optional<double> heightAt(const Triangle& t, const Vector2d& at) {
  const Vector2d a = (t[1] - t[0]).head<2>(), b = (t[2] - t[0]).head<2>(), c = at - t[0].head<2>();
  const double area = cross(a, b);
  if (std::abs(area) < 1e-12) return std::nullopt;
  const double s = cross(c, b) / area, r = cross(a, c) / area;
  if (s < -1e-9 || r < -1e-9 || s + r > 1 + 1e-9) return std::nullopt;
  return t[0].z() + s * (t[1].z() - t[0].z()) + r * (t[2].z() - t[0].z());
}

/// Calls take(height) at the points where the triangle's edges cross the outline, and at the outline's
/// corners over the triangle.
template <class Take>
void alongOutline(const Triangle& t, const std::vector<Vector2d>& outline, Take take) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d &p = outline[i], &q = outline[(i + 1) % outline.size()];
    const Vector2d low = p.cwiseMin(q), high = p.cwiseMax(q);
    for (int k = 0; k < 3; ++k) {
      const OverPlate &a = t[std::size_t(k)], &b = t[std::size_t((k + 1) % 3)];
      const Vector2d edge = (b - a).head<2>(), side = q - p, from = p - a.head<2>();
      if (std::max(a.x(), b.x()) < low.x() || std::min(a.x(), b.x()) > high.x() ||
          std::max(a.y(), b.y()) < low.y() || std::min(a.y(), b.y()) > high.y())
        continue;
      const double turn = cross(edge, side);
      if (std::abs(turn) < 1e-12) continue;
      const double on_edge = cross(from, side) / turn, on_side = cross(from, edge) / turn;
      if (on_edge >= 0 && on_edge <= 1 && on_side >= 0 && on_side <= 1)
        take(a.z() + on_edge * (b.z() - a.z()));
    }
    if (const auto height = heightAt(t, p)) take(*height);
  }
}

}  // namespace

double radius_mm(const CoilPlate& plate) {
  double radius = 0;
  for (const Vector2d& p : plate.outline_mm) radius = std::max(radius, p.norm());
  return radius;
}

surface::TriangleMesh partWithin(const surface::TriangleMesh& mesh, const Vector3d& centre_mm,
                                 double radius_mm) {
  std::vector<int> index(mesh.vertices_mm.size(), -1);
  const auto isNear = [&](int v) {
    return (mesh.vertices_mm[std::size_t(v)] - centre_mm).squaredNorm() < radius_mm * radius_mm;
  };
  surface::TriangleMesh part;
  for (const auto& t : mesh.triangles) {
    if (!isNear(t[0]) && !isNear(t[1]) && !isNear(t[2])) continue;
    Eigen::Vector3i corners;
    for (int k = 0; k < 3; ++k) {
      int& here = index[std::size_t(t[k])];
      if (here < 0)
        here = int(part.vertices_mm.size()), part.vertices_mm.push_back(mesh.vertices_mm[std::size_t(t[k])]);
      corners[k] = here;
    }
    part.triangles.push_back(corners);
  }
  return part;
}

bool isInside(const std::vector<Vector2d>& outline, const Vector2d& p) {
  bool is_inside = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Vector2d &a = outline[i], &b = outline[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x())
      is_inside = !is_inside;
  }
  return is_inside;
}

std::vector<OverPlate> skinUnder(const surface::TriangleMesh& skin, const CoilPlate& plate,
                                 const Matrix3d& axes, const Vector3d& pivot_mm) {
  const double within_mm = radius_mm(plate);
  std::vector<OverPlate> places;
  double top = -1e300;
  for (const Vector3d& v : skin.vertices_mm) {
    const OverPlate p = over(v, axes, pivot_mm);
    if (p.head<2>().norm() > within_mm || !isInside(plate.outline_mm, p.head<2>())) continue;
    places.push_back(p);
    top = std::max(top, p.z());
  }
  places.erase(std::remove_if(places.begin(), places.end(),
                              [&](const OverPlate& p) { return p.z() < top - kReach_mm; }),
               places.end());
  return places;
}

std::optional<double> highest(const surface::TriangleMesh& skin, const CoilPlate& plate, const Matrix3d& axes,
                              const Vector3d& pivot_mm) {
  std::vector<OverPlate> all;
  std::vector<char> inside;
  const double within_mm = radius_mm(plate);
  std::optional<double> top;
  const auto take = [&](double height) { top = std::max(top.value_or(height), height); };
  for (const Vector3d& v : skin.vertices_mm) {
    all.push_back(over(v, axes, pivot_mm));
    inside.push_back(all.back().head<2>().norm() <= within_mm &&
                     isInside(plate.outline_mm, all.back().head<2>()));
    if (inside.back()) take(all.back().z());
  }
  constexpr double kBesideTriangle_mm = 20;
  for (const auto& t : skin.triangles) {
    const Triangle triangle{all[std::size_t(t[0])], all[std::size_t(t[1])], all[std::size_t(t[2])]};
    const bool has_all = inside[std::size_t(t[0])] && inside[std::size_t(t[1])] && inside[std::size_t(t[2])];
    const double high = std::max({triangle[0].z(), triangle[1].z(), triangle[2].z()});
    if (has_all || (top && high <= *top) || triangle[0].head<2>().norm() > within_mm + kBesideTriangle_mm)
      continue;
    alongOutline(triangle, plate.outline_mm, take);
  }
  return top;
}

std::optional<double> heightOnAxis(const surface::TriangleMesh& skin, const Matrix3d& axes,
                                   const Vector3d& pivot_mm) {
  std::optional<double> top;
  for (const auto& t : skin.triangles) {
    const Vector3d &a = skin.vertices_mm[std::size_t(t[0])], &b = skin.vertices_mm[std::size_t(t[1])],
                   &c = skin.vertices_mm[std::size_t(t[2])];
    const OverPlate first = over(a, axes, pivot_mm);
    const double longest2 = std::max((b - a).squaredNorm(), (c - a).squaredNorm());
    if (first.head<2>().squaredNorm() > longest2) continue;  // too far from the axis to contain it
    const Triangle triangle{first, over(b, axes, pivot_mm), over(c, axes, pivot_mm)};
    if (const auto height = heightAt(triangle, Vector2d::Zero()))
      top = std::max(top.value_or(*height), *height);
  }
  return top;
}

std::optional<Vector3d> normalRound(const surface::TriangleMesh& skin, const Matrix3d& axes,
                                    const Vector3d& pivot_mm, double height_mm, double sigma_mm) {
  Vector3d sum = Vector3d::Zero();
  const double reach_mm = 3 * sigma_mm;
  const Vector3d centre = pivot_mm - height_mm * axes.col(2);
  for (const auto& t : skin.triangles) {
    const Vector3d &a = skin.vertices_mm[std::size_t(t[0])], &b = skin.vertices_mm[std::size_t(t[1])],
                   &c = skin.vertices_mm[std::size_t(t[2])];
    const double away = ((a + b + c) / 3 - centre).norm();
    if (away > reach_mm) continue;
    const Vector3d area = (b - a).cross(c - a);
    if (area.dot(axes.col(2)) < 0) sum += std::exp(-0.5 * away * away / (sigma_mm * sigma_mm)) * area;
  }
  if (sum.norm() < 1e-9) return std::nullopt;
  return sum.normalized();
}

double heightOfPlate(const std::vector<OverPlate>& places, const Vector2d& slope) {
  double height = -1e300;
  for (const OverPlate& p : places) height = std::max(height, p.z() - slope.dot(p.head<2>()));
  return height;
}

std::optional<Vector2d> pressedSlope(const std::vector<OverPlate>& places) {
  // Finds the facet of the upper hull that the axis meets. At first three far, low points surround the axis.
  // Each round replaces a corner by the point that is highest over the facet, so that the axis stays inside.
  // The facet only rises, so the loop ends.
  constexpr double kFar_mm = 1e3, kLow_mm = -1e5, kTouching_mm = 1e-6;
  constexpr int kMostRounds = 500;
  Triangle facet;
  for (int k = 0; k < 3; ++k) {
    const double angle = M_PI / 2 + k * 2 * M_PI / 3;
    facet[std::size_t(k)] = {kFar_mm * std::cos(angle), kFar_mm * std::sin(angle), kLow_mm};
  }
  for (int round = 0; round < kMostRounds; ++round) {
    const Vector3d n = (facet[1] - facet[0]).cross(facet[2] - facet[0]);
    if (std::abs(n.z()) < 1e-12) return std::nullopt;
    const Vector2d slope(-n.x() / n.z(), -n.y() / n.z());
    const double base = facet[0].z() - slope.dot(facet[0].head<2>());
    const OverPlate* best = nullptr;
    double most = kTouching_mm;
    for (const OverPlate& p : places)
      if (const double above = p.z() - slope.dot(p.head<2>()) - base; above > most) most = above, best = &p;
    if (!best) {
      const bool is_held =
          std::none_of(facet.begin(), facet.end(), [](const OverPlate& p) { return p.z() <= kLow_mm; });
      return is_held ? std::optional(slope) : std::nullopt;
    }
    std::optional<Triangle> next;
    double widest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      Triangle with = facet;
      with[k] = *best;
      if (!heightAt(with, Vector2d::Zero())) continue;
      const double area = std::abs(cross((with[1] - with[0]).head<2>(), (with[2] - with[0]).head<2>()));
      if (area > widest) widest = area, next = with;
    }
    if (!next) return std::nullopt;
    facet = *next;
  }
  return std::nullopt;
}

}  // namespace facenav::guidance
