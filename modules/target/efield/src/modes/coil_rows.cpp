#include "modes/coil_rows.h"

#include <algorithm>
#include <cmath>

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

/// (p - r) / |p - r|^3
Eigen::Vector3f pull(const Eigen::Vector3f& p, const Eigen::Vector3f& r) {
  const Eigen::Vector3f to = p - r;
  const float square = to.squaredNorm();
  return to / (square * std::sqrt(square));
}

/// Replaces the lumps of charge of the first shell's triangles near to a place by spread charges. `squares`:
/// room for a number a triangle.
void spreadNear(const BoundarySystem& system, const Eigen::Vector3f& place, Eigen::VectorXf& squares,
                float* const pulls[3]) {
  const SpreadCharges& spread = system.spread;
  squares = (spread.centres.x.array() - place.x()).square() +
            (spread.centres.y.array() - place.y()).square() + (spread.centres.z.array() - place.z()).square();
  for (Index t = 0; t < spread.corners.cols(); ++t) {
    if (squares[t] >= spread.reach_mm * spread.reach_mm) continue;
    Eigen::Matrix3f change = Eigen::Matrix3f::Zero();  // by corner
    for (int n = 0; n < SpreadCharges::kNodes; ++n) {
      const Eigen::Vector3f at = pull(spread.nodes.col(t * SpreadCharges::kNodes + n), place);
      for (int v = 0; v < 3; ++v) change.col(v) += spread.shares[n][v] * at;
    }
    for (int v = 0; v < 3; ++v) {
      const Index vertex = spread.corners(v, t);
      const Eigen::Vector3f lump(system.vertices.x[vertex], system.vertices.y[vertex],
                                 system.vertices.z[vertex]);
      change.col(v) -= SpreadCharges::kNodes / 3.f * pull(lump, place);
      for (int axis = 0; axis < 3; ++axis) pulls[axis][vertex] += spread.areas(v, t) * change(axis, v);
    }
  }
}

void writePulls(const BoundarySystem& system, const PointArrays& points, Eigen::MatrixXf& pulls) {
  const Index count = points.x.size();
  pulls.resize(system.vertices.x.size(), 3 * count);
  parallelRanges(0, int(count), [&](int begin, int end) {
    Eigen::VectorXf squares;
    for (int p = begin; p < end; ++p) {
      float* const columns[3] = {pulls.col(p).data(), pulls.col(count + p).data(),
                                 pulls.col(2 * count + p).data()};
      const Eigen::Vector3f place(points.x[p], points.y[p], points.z[p]);
      kernels::kernel().pull(
          {system.vertices.points(), {place.x(), place.y(), place.z()}, columns[0], columns[1], columns[2]});
      spreadNear(system, place, squares, columns);
    }
  });
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
  Eigen::MatrixXf pulls;
  writePulls(system, points, pulls);
  return pulls;
}

const Eigen::MatrixXf& PullBlocks::at(const PointArrays& points) {
  writePulls(system_, points, pulls_);
  return pulls_;
}

}  // namespace facenav::efield
