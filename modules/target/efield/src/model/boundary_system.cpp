#include "model/boundary_system.h"

#include <Eigen/Geometry>

#include "facenav/core/error.h"
#include "kernels/field_kernel.h"

namespace facenav::efield {
namespace {

using Eigen::Index;

constexpr float kFarAway_mm = 1e5f;

/// Centre of each vertex' part of the surface: its linear function's mean place, by area.
Eigen::Matrix3Xd fluxPlaces(const ShellMesh& mesh) {
  Eigen::Matrix3Xd sums = Eigen::Matrix3Xd::Zero(3, mesh.vertices_mm.cols());
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.vertices_mm.cols());
  for (const auto triangle : mesh.triangles.colwise()) {
    Eigen::Matrix3d corners;
    for (int c = 0; c < 3; ++c) corners.col(c) = mesh.vertices_mm.col(triangle[c]);
    const double area = 0.5 * (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0)).norm();
    for (int c = 0; c < 3; ++c) {
      sums.col(triangle[c]) += area / 4 * (corners.col(c) + corners.rowwise().sum());
      areas[triangle[c]] += area;
    }
  }
  for (Index i = 0; i < sums.cols(); ++i) sums.col(i) /= areas[i];
  return sums;
}

}  // namespace

PointArrays::PointArrays(const Eigen::Matrix3Xd& points_mm) : count(points_mm.cols()) {
  const Index padded = (count + kernels::kLanes - 1) / kernels::kLanes * kernels::kLanes;
  Eigen::VectorXf* axes[3] = {&x, &y, &z};
  for (int axis = 0; axis < 3; ++axis) {
    axes[axis]->setConstant(padded, kFarAway_mm);
    axes[axis]->head(count) = points_mm.row(axis).transpose().cast<float>();
  }
}

std::vector<Shell> shellsOf(const HeadModel& head, const Conductivities& s) {
  requireClosed(head.scalp, "scalp");
  requireClosed(head.outer_skull, "outer skull");
  requireClosed(head.inner_skull, "inner skull");
  std::vector<Shell> shells;
  if (head.brain) {
    requireClosed(*head.brain, "brain");
    shells.push_back({*head.brain, s.brain, s.fluid});
  }
  shells.push_back({head.inner_skull, head.brain ? s.fluid : s.brain, s.skull});
  shells.push_back({head.outer_skull, s.skull, s.scalp});
  shells.push_back({head.scalp, s.scalp, 0.0});
  return shells;
}

SpreadCharges::SpreadCharges(const ShellMesh& mesh) : corners(mesh.triangles) {
  constexpr int kParts = 3;            // of an edge
  constexpr double kReachEdges = 2.5;  // farther away the lumps leave 0.1 %
  std::vector<Eigen::Vector3d> middles;
  for (int i = 0; i < kParts; ++i)
    for (int j = 0; i + j < kParts; ++j) {
      middles.emplace_back(3 * (kParts - i - j) - 2, 3 * i + 1, 3 * j + 1);
      if (i + j + 1 < kParts) middles.emplace_back(3 * (kParts - i - j) - 4, 3 * i + 2, 3 * j + 2);
    }
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(mesh.vertices_mm.cols());
  areas.resize(3, corners.cols());
  Eigen::VectorXd triangle_areas(corners.cols());
  for (Index t = 0; t < corners.cols(); ++t) {
    const Eigen::Vector3d a = mesh.vertices_mm.col(corners(0, t));
    const Eigen::Vector3d b = mesh.vertices_mm.col(corners(1, t)), c = mesh.vertices_mm.col(corners(2, t));
    triangle_areas[t] = 0.5 * (b - a).cross(c - a).norm();
    for (int v = 0; v < 3; ++v) sums[corners(v, t)] += triangle_areas[t] / 3;
  }
  for (Index t = 0; t < corners.cols(); ++t)
    for (int v = 0; v < 3; ++v) areas(v, t) = float(triangle_areas[t] / kNodes / sums[corners(v, t)]);
  nodes.resize(3, kNodes * corners.cols());
  Eigen::Matrix3Xd middle_places(3, corners.cols());
  for (Index t = 0; t < corners.cols(); ++t) {
    Eigen::Matrix3d at;
    for (int v = 0; v < 3; ++v) at.col(v) = mesh.vertices_mm.col(corners(v, t));
    middle_places.col(t) = at.rowwise().mean();
    for (int node = 0; node < kNodes; ++node)
      nodes.col(kNodes * t + node) = (at * middles[std::size_t(node)] / (3.0 * kParts)).cast<float>();
  }
  for (int node = 0; node < kNodes; ++node)
    for (int v = 0; v < 3; ++v) shares[node][v] = float(middles[std::size_t(node)][v] / (3.0 * kParts));
  centres = PointArrays(middle_places);
  reach_mm = float(kReachEdges * vertexEdges_mm(mesh).mean());
}

BoundarySystem::BoundarySystem(const std::vector<Shell>& shells, TaskMonitor& monitor)
    : spread(shells.front().mesh) {
  first.push_back(0);
  for (const Shell& shell : shells) first.push_back(first.back() + shell.mesh.vertices_mm.cols());
  vertices_mm.resize(3, first.back());
  flux_weights.resize(3, first.back());
  Eigen::Matrix3Xd places(3, first.back());
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const Index count = first[s + 1] - first[s];
    vertices_mm.middleCols(first[s], count) = shells[s].mesh.vertices_mm;
    places.middleCols(first[s], count) = fluxPlaces(shells[s].mesh);
    flux_weights.middleCols(first[s], count) =
        ((shells[s].outside - shells[s].inside) * vertexAreas_mm2(shells[s].mesh)).cast<float>();
  }
  vertices = PointArrays(vertices_mm);
  flux_places = PointArrays(places);
  // The potential is known up to a constant; this makes its mean 0.
  lu = boundaryMatrix(shells, shells.front().inside / double(size()), monitor);
  monitor.report("electric field: solving", 0.0);
  pivots = dense::factorise(dense::viewOf(lu),
                            [&](double share) { monitor.report("electric field: solving", share); });
}

void BoundarySystem::removeMeans(Eigen::Ref<Eigen::MatrixXf> columns) const {
  for (std::size_t s = 0; s + 1 < first.size(); ++s) {
    auto part = columns.middleRows(first[s], first[s + 1] - first[s]);
    for (auto column : part.colwise()) column.array() -= column.mean();
  }
}

}  // namespace facenav::efield
