#include "facenav/efield/field_solver.h"

#include <algorithm>

#include "facenav/surface/closest_point.h"
#include "model/boundary_system.h"
#include "model/shell_surface.h"
#include "modes/coil_rows.h"

namespace facenav::efield {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

constexpr double kLeastDepthEdges = 0.4;  // of a point below the innermost surface, in edges of its triangles

/// Field of the coil alone, in field units.
Vector3d ownField(const DipoleArray& dipoles, const Vector3d& place) {
  Vector3d sum = Vector3d::Zero();
  for (Index d = 0; d < dipoles.size(); ++d) {
    const Vector3d from = place - dipoles.positions_mm.col(d).cast<double>();
    sum += dipoles.moments.col(d).cast<double>().cross(from) / (from.squaredNorm() * from.norm());
  }
  return sum;
}

}  // namespace

FieldSolver::FieldSolver(HeadModel head, const Conductivities& conductivities, TaskMonitor& monitor)
    : head_(std::move(head)),
      system_(std::make_unique<BoundarySystem>(shellsOf(head_, conductivities), monitor)) {}
FieldSolver::~FieldSolver() = default;
FieldSolver::FieldSolver(FieldSolver&&) noexcept = default;
FieldSolver& FieldSolver::operator=(FieldSolver&&) noexcept = default;

Eigen::Matrix3Xd FieldSolver::fieldAt(const CoilDipoles& coil,
                                      const RigidTransform<Mri, frames::Coil>& mri_T_coil,
                                      const Eigen::Matrix3Xd& points_mm) const {
  const DipoleArray dipoles = dipolesAt(coil, mri_T_coil);
  Eigen::MatrixXf weights = fluxOf(*system_, dipoles);
  system_->removeMeans(weights);
  dense::solveTransposed(dense::viewOf(system_->lu), system_->pivots, dense::viewOf(weights));
  const Eigen::VectorXf weight = weights.col(0) / float(4 * M_PI);
  constexpr Index kAtOnce = 256;
  Eigen::Matrix3Xd field(3, points_mm.cols());
  for (Index first = 0; first < points_mm.cols(); first += kAtOnce) {
    const Index count = std::min(kAtOnce, points_mm.cols() - first);
    const PointArrays block(points_mm.middleCols(first, count));
    const Eigen::MatrixXf pulls = pullsAt(*system_, block);
    const Index padded = block.x.size();
    for (Index p = 0; p < count; ++p) {
      Vector3d sum = ownField(dipoles, points_mm.col(first + p));
      for (int axis = 0; axis < 3; ++axis)
        sum[axis] += double(pulls.col(axis * padded + p).head(weight.size()).dot(weight));
      field.col(first + p) = kFieldOfUnits * sum;
    }
  }
  return field;
}

ReachablePoints reachablePoints(const ShellMesh& innermost, const Eigen::Matrix3Xd& points_mm) {
  const surface::ClosestPoint surface(triangleMesh(innermost));
  const Eigen::VectorXd edges_mm = vertexEdges_mm(innermost);
  ReachablePoints reachable{points_mm, std::vector<bool>(std::size_t(points_mm.cols()))};
  std::optional<int> near;
  for (Index p = 0; p < points_mm.cols(); ++p) {
    const auto place = surface.nearest(Point<Mri>(points_mm.col(p)), near);
    near = place.triangle;
    double edge_mm = 0;
    for (int c = 0; c < 3; ++c) edge_mm += edges_mm[innermost.triangles(c, place.triangle)] / 3;
    const double least_mm = kLeastDepthEdges * edge_mm;
    if (!place.is_outside && place.distance_mm >= least_mm) continue;
    reachable.points_mm.col(p) = place.point.mm - least_mm * place.normal.v;
    reachable.is_moved[std::size_t(p)] = true;
  }
  return reachable;
}

}  // namespace facenav::efield
