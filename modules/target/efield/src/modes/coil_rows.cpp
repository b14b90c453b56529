#include "modes/coil_rows.h"

#include <algorithm>

#include "facenav/core/parallel_for.h"

namespace facenav::efield {
namespace {

using Eigen::Index;

/// Field of `count` dipoles together at the flux places, times the weights.
void writeFlux(const BoundarySystem& system, const float* positions, const float* moments, int count,
               float* flux) {
  const kernels::Points points = system.flux_places.points();
  Eigen::MatrixXf field(points.count, 3);
  kernels::kernel().dipoles(
      {points, positions, moments, count, field.col(0).data(), field.col(1).data(), field.col(2).data()});
  Eigen::Map<Eigen::VectorXf> out(flux, system.size());
  out.setZero();
  for (int axis = 0; axis < 3; ++axis)
    out.array() +=
        field.col(axis).head(system.size()).array() * system.flux_weights.row(axis).transpose().array();
}

bool isNear(const BoundarySystem& system, const Eigen::Vector3f& place) {
  const Index count = system.first[1];
  const auto squares = (system.vertices.x.head(count).array() - place.x()).square() +
                       (system.vertices.y.head(count).array() - place.y()).square() +
                       (system.vertices.z.head(count).array() - place.z()).square();
  return squares.minCoeff() < system.spread.reach_mm * system.spread.reach_mm;
}

/// Replaces the pull of the first shell's vertices by that of their charges spread over the triangles.
void spreadPull(const BoundarySystem& system, const Eigen::Vector3f& place, float* const pulls[3]) {
  const SpreadCharges& spread = system.spread;
  const Index count = spread.corners.cols(), padded = spread.nodes[0].x.size();
  Eigen::MatrixXf node(padded, 3), sums[3];
  for (auto& sum : sums) sum = Eigen::MatrixXf::Zero(padded, 3);
  for (int n = 0; n < SpreadCharges::kNodes; ++n) {
    kernels::kernel().pull({spread.nodes[std::size_t(n)].points(),
                            {place.x(), place.y(), place.z()},
                            node.col(0).data(),
                            node.col(1).data(),
                            node.col(2).data()});
    for (int v = 0; v < 3; ++v) sums[v] += spread.shares[n][v] * node;
  }
  for (int axis = 0; axis < 3; ++axis) {
    std::fill(pulls[axis], pulls[axis] + system.first[1], 0.f);
    for (Index t = 0; t < count; ++t)
      for (int v = 0; v < 3; ++v) pulls[axis][spread.corners(v, t)] += sums[v](t, axis) * spread.areas(v, t);
  }
}

}  // namespace

DipoleArray dipolesAt(const CoilDipoles& coil, const RigidTransform<Mri, frames::Coil>& mri_T_coil) {
  DipoleArray dipoles;
  dipoles.positions_mm =
      ((mri_T_coil.rotation() * coil.positions_mm).colwise() + Eigen::Vector3d(mri_T_coil.translation_mm()))
          .cast<float>();
  dipoles.moments = (mri_T_coil.rotation() * coil.moments_Am2).cast<float>();
  return dipoles;
}

Eigen::MatrixXf fluxOf(const BoundarySystem& system, const DipoleArray& dipoles) {
  Eigen::MatrixXf flux(system.size(), 1);
  writeFlux(system, dipoles.positions_mm.data(), dipoles.moments.data(), int(dipoles.size()), flux.data());
  return flux;
}

Eigen::MatrixXf fluxOfEach(const BoundarySystem& system, const SourceArray& sources) {
  Eigen::MatrixXf flux(system.size(), sources.size());
  const int each = sources.dipoles_each;
  parallelRanges(0, int(sources.size()), [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      writeFlux(system, sources.dipoles.positions_mm.col(i * each).data(),
                sources.dipoles.moments.col(i * each).data(), each, flux.col(i).data());
  });
  return flux;
}

Eigen::MatrixXf primaryOfEach(const PointArrays& points, const SourceArray& sources) {
  const Index count = points.x.size();
  Eigen::MatrixXf field(3 * count, sources.size());
  const int each = sources.dipoles_each;
  parallelRanges(0, int(sources.size()), [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      float* column = field.col(i).data();
      kernels::kernel().dipoles({points.points(), sources.dipoles.positions_mm.col(i * each).data(),
                                 sources.dipoles.moments.col(i * each).data(), each, column, column + count,
                                 column + 2 * count});
    }
  });
  return field;
}

Eigen::MatrixXf pullsAt(const BoundarySystem& system, const PointArrays& points) {
  const Index count = points.x.size(), size = system.vertices.x.size();
  Eigen::MatrixXf pulls(size, 3 * count);
  parallelRanges(0, int(count), [&](int begin, int end) {
    for (int p = begin; p < end; ++p) {
      float* const columns[3] = {pulls.col(p).data(), pulls.col(count + p).data(),
                                 pulls.col(2 * count + p).data()};
      const Eigen::Vector3f place(points.x[p], points.y[p], points.z[p]);
      kernels::kernel().pull(
          {system.vertices.points(), {place.x(), place.y(), place.z()}, columns[0], columns[1], columns[2]});
      if (isNear(system, place)) spreadPull(system, place, columns);
    }
  });
  return pulls;
}

}  // namespace facenav::efield
