#include "facenav/efield/field_solver.h"

#include <algorithm>
#include <optional>

#include "facenav/core/error.h"
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

void FieldSolver::dropEquations() { system_->lu.resize(0, 0); }

Eigen::Matrix3Xd FieldSolver::fieldAt(const CoilDipoles& coil,
                                      const RigidTransform<Mri, frames::Coil>& mri_T_coil,
                                      const Eigen::Matrix3Xd& points_mm) const {
  FACENAV_EXPECT(system_->lu.size() > 0, "the equations, which dropEquations() frees");
  const DipoleArray dipoles = dipolesAt(coil, mri_T_coil);
  Eigen::MatrixXf weights = fluxOf(*system_, dipoles);
  system_->removeMeans(weights);
  dense::solveTransposed(dense::viewOf(system_->lu), system_->pivots, dense::viewOf(weights));
  const Eigen::VectorXf weight = weights.col(0) / float(4 * M_PI);
  constexpr Index kAtOnce = 256;
  PullBlocks pull_blocks(*system_);
  Eigen::Matrix3Xd field(3, points_mm.cols());
  for (Index first = 0; first < points_mm.cols(); first += kAtOnce) {
    const Index count = std::min(kAtOnce, points_mm.cols() - first);
    const PointArrays block(points_mm.middleCols(first, count));
    const Eigen::MatrixXf& pulls = pull_blocks.at(block);
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

namespace {

/// Moves points to a depth below a surface.
class Depth {
 public:
  explicit Depth(const ShellMesh& mesh)
      : mesh_(mesh), surface_(triangleMesh(mesh)), edges_mm_(vertexEdges_mm(mesh)) {}

  /// True if the point was moved. In a fold thinner than twice the depth it ends near the fold's middle.
  bool move(Vector3d& point_mm) {
    constexpr int kSteps = 10;
    bool is_moved = false;
    double best = -1e9;  // part of the wanted depth
    Vector3d best_mm = point_mm;
    for (int step = 0; step < kSteps; ++step) {
      const auto place = surface_.nearest(Point<Mri>(point_mm), near_);
      near_ = place.triangle;
      const double least_mm = kLeastDepthEdges * edgeOf_mm(place.triangle);
      const double depth = (place.is_outside ? -place.distance_mm : place.distance_mm) / least_mm;
      if (depth > best) best = depth, best_mm = point_mm;
      // A moved point rounds to a little less.
      if (depth >= (is_moved ? 0.999 : 1.0)) return is_moved;
      is_moved = true;
      const double aim_mm = least_mm * (1 - 0.5 * step / kSteps);
      point_mm = place.point.mm - aim_mm * place.normal.v;
    }
    point_mm = best_mm;
    return true;
  }

 private:
  double edgeOf_mm(int triangle) const {
    double sum_mm = 0;
    for (int c = 0; c < 3; ++c) sum_mm += edges_mm_[mesh_.triangles(c, triangle)];
    return sum_mm / 3;
  }

  const ShellMesh& mesh_;
  surface::ClosestPoint surface_;
  Eigen::VectorXd edges_mm_;
  std::optional<int> near_;
};

}  // namespace

ReachablePoints reachablePoints(const ShellMesh& innermost, const Eigen::Matrix3Xd& points_mm) {
  Depth depth(innermost);
  ReachablePoints reachable{points_mm, std::vector<bool>(std::size_t(points_mm.cols()))};
  for (Index p = 0; p < points_mm.cols(); ++p) {
    Vector3d place_mm = points_mm.col(p);
    reachable.is_moved[std::size_t(p)] = depth.move(place_mm);
    reachable.points_mm.col(p) = place_mm;
  }
  return reachable;
}

}  // namespace facenav::efield
