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

BoundarySystem::BoundarySystem(const std::vector<Shell>& shells, TaskMonitor& monitor) {
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
  pivots = dense::factorise(dense::viewOf(lu));
}

void BoundarySystem::removeMeans(Eigen::Ref<Eigen::MatrixXf> columns) const {
  for (std::size_t s = 0; s + 1 < first.size(); ++s) {
    auto part = columns.middleRows(first[s], first[s + 1] - first[s]);
    for (auto column : part.colwise()) column.array() -= column.mean();
  }
}

}  // namespace facenav::efield
