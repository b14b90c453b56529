#include "modes/packed_modes.h"

#include <cmath>

#include "facenav/core/error.h"
#include "kernels/field_kernel.h"
#include "modes/coil_rows.h"

namespace facenav::efield {
namespace {

using Eigen::Index;
using kernels::kBlock;
constexpr float kLargest = 32767.f;

}  // namespace

Index paddedRows(Index points) { return (3 * points + kBlock - 1) / kBlock * kBlock; }

std::vector<float> packedFloats(const Eigen::MatrixXf& matrix) {
  FACENAV_EXPECT(matrix.rows() % kBlock == 0, "whole blocks of rows");
  std::vector<float> packed;
  packed.reserve(std::size_t(matrix.size()));
  for (Index first = 0; first < matrix.rows(); first += kBlock)
    for (Index column = 0; column < matrix.cols(); ++column)
      for (Index row = first; row < first + kBlock; ++row) packed.push_back(matrix(row, column));
  return packed;
}

PackedShapes::PackedShapes(Index points, Index modes) : points_(points), values_(3 * points, modes) {}

void PackedShapes::add(const Eigen::MatrixXf& rows, Index first, Index count) {
  const Index stride = rows.rows() / 3;
  for (Index mode = 0; mode < values_.cols(); ++mode)
    for (Index p = 0; p < count; ++p)
      for (int axis = 0; axis < 3; ++axis)
        values_(3 * (first + p) + axis, mode) = rows(axis * stride + p, mode);
}

void PackedShapes::finish(CortexField& field) {
  const Index modes = values_.cols(), inputs = 3 * field.samples_mm.cols();
  field.shapes.assign(std::size_t(paddedRows(points_) * modes), 0);
  for (Index mode = 0; mode < modes; ++mode) {
    const float largest = std::max(values_.col(mode).cwiseAbs().maxCoeff(), 1e-20f);
    for (Index row = 0; row < values_.rows(); ++row)
      field.shapes[std::size_t(((row / kBlock) * modes + mode) * kBlock + row % kBlock)] =
          std::int16_t(std::lround(values_(row, mode) / largest * kLargest));
    for (Index j = 0; j < inputs; ++j)
      field.intake[std::size_t(((mode / kBlock) * inputs + j) * kBlock + mode % kBlock)] *=
          largest / kLargest;
  }
}

Eigen::Matrix3Xf fieldAt(const CortexField& field, const CoilDipoles& coil,
                         const RigidTransform<Mri, frames::Coil>& mri_T_coil) {
  const DipoleArray dipoles = dipolesAt(coil, mri_T_coil);
  const Index samples = field.samples_mm.cols(), rows = paddedRows(field.points_mm.cols());
  const Eigen::MatrixXf places = field.samples_mm.transpose();
  Eigen::MatrixXf own(samples, 3);
  const auto& kernel = kernels::kernel();
  kernel.dipoles({{places.col(0).data(), places.col(1).data(), places.col(2).data(), samples},
                  dipoles.positions_mm.data(),
                  dipoles.moments.data(),
                  int(dipoles.size()),
                  own.col(0).data(),
                  own.col(1).data(),
                  own.col(2).data()});
  Eigen::VectorXf modes(field.modes);
  kernel.expandFloats({field.modes / kBlock, 3 * samples, own.data(), modes.data()}, field.intake.data());
  Eigen::Matrix3Xf result(3, (rows + 2) / 3);
  kernel.expandShorts({rows / kBlock, field.modes, modes.data(), result.data()}, field.shapes.data());
  result.conservativeResize(3, field.points_mm.cols());
  return result;
}

}  // namespace facenav::efield
