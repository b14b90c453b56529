#include "model/radial_shell.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "facenav/core/parallel_for.h"
#include "facenav/surface/closest_point.h"
#include "model/shell_surface.h"

namespace facenav::efield {

using Eigen::Index;

ShellMesh RadialShell::mesh() const {
  ShellMesh mesh = directions;
  mesh.vertices_mm = (directions.vertices_mm * radius_mm.asDiagonal()).colwise() + middle;
  return mesh;
}

Eigen::VectorXd RadialShell::cosines() const {
  constexpr double kSteepest = 0.3;
  const Eigen::Matrix3Xd areas = vertexAreas_mm2(mesh());
  Eigen::VectorXd cosines(radius_mm.size());
  for (Index i = 0; i < cosines.size(); ++i)
    cosines[i] = std::max(kSteepest, areas.col(i).normalized().dot(directions.vertices_mm.col(i)));
  return cosines;
}

RadialShell inDirections(const RadialShell& shell, const ShellMesh& directions) {
  const ShellMesh& old = shell.directions;
  std::vector<Eigen::Matrix3d> shares_of;  // a direction to its shares of a triangle's corners
  for (const auto triangle : old.triangles.colwise()) {
    Eigen::Matrix3d corners;
    for (int c = 0; c < 3; ++c) corners.col(c) = old.vertices_mm.col(triangle[c]);
    shares_of.push_back(corners.inverse());
  }
  RadialShell result{shell.middle, directions, Eigen::VectorXd(directions.vertices_mm.cols())};
  parallelRanges(0, int(result.radius_mm.size()), [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      double best = -1e9;
      Eigen::Vector3d shares = Eigen::Vector3d::Zero();
      Index at = 0;
      for (std::size_t t = 0; t < shares_of.size(); ++t) {
        const Eigen::Vector3d here = shares_of[t] * directions.vertices_mm.col(i);
        // The triangle that the direction meets has no negative share, the opposite one has no positive one.
        if (here.minCoeff() > best) best = here.minCoeff(), shares = here, at = Index(t);
      }
      double sum_mm = 0;
      for (int c = 0; c < 3; ++c) sum_mm += shares[c] * shell.radius_mm[old.triangles(c, at)];
      result.radius_mm[i] = sum_mm / shares.sum();
    }
  });
  return result;
}

Eigen::VectorXd smoothedOn(const ShellMesh& mesh, Eigen::VectorXd values, int steps) {
  for (int step = 0; step < steps; ++step) {
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(values.size()), counts = sums;
    for (const auto triangle : mesh.triangles.colwise())
      for (int c = 0; c < 3; ++c) {
        sums[triangle[c]] += values[triangle[(c + 1) % 3]];
        counts[triangle[c]] += 1;
      }
    values = 0.5 * (values + sums.cwiseQuotient(counts));
  }
  return values;
}

Eigen::VectorXd gaps_mm(const ShellMesh& inner, const ShellMesh& outer) {
  const surface::ClosestPoint surface(triangleMesh(inner));
  Eigen::VectorXd gaps(outer.vertices_mm.cols());
  for (Index i = 0; i < gaps.size(); ++i) {
    const auto place = surface.nearest(Point<Mri>(outer.vertices_mm.col(i)));
    gaps[i] = place.is_outside ? place.distance_mm : -place.distance_mm;
  }
  return gaps;
}

double edgeAlong(const std::function<double(const Eigen::Vector3d&)>& value, const Eigen::Vector3d& middle,
                 const Eigen::Vector3d& direction, double reach_mm, bool is_first) {
  constexpr double kStep_mm = 0.5;
  double edge_mm = 0, before = value(middle);
  for (double r_mm = kStep_mm; r_mm <= reach_mm; r_mm += kStep_mm) {
    const double here = value(middle + r_mm * direction);
    if (before >= 0.5 && here < 0.5) {
      edge_mm = r_mm - kStep_mm * (0.5 - here) / (before - here);
      if (is_first) return edge_mm;
    }
    before = here;
  }
  return before >= 0.5 ? reach_mm : edge_mm;
}

}  // namespace facenav::efield
