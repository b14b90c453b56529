#include "modes/coil_rows.h"

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
    for (int p = begin; p < end; ++p)
      kernels::kernel().pull({system.vertices.points(),
                              {points.x[p], points.y[p], points.z[p]},
                              pulls.col(p).data(),
                              pulls.col(count + p).data(),
                              pulls.col(2 * count + p).data()});
  });
  return pulls;
}

}  // namespace facenav::efield
