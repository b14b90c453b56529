#pragma once
// The arrays of CortexField in the order that the kernels read: blocks of 32 rows, column by column.

#include "facenav/efield/cortex_field.h"

namespace facenav::efield {

/// Packs a matrix whose number of rows is a multiple of 32.
std::vector<float> packedFloats(const Eigen::MatrixXf& matrix);

/// Collects the modes at the points and rounds them to 16 bits, each mode with its own scale.
class PackedShapes {
 public:
  PackedShapes(Eigen::Index points, Eigen::Index modes);
  /// Adds points `first` .. : rows x of all points (padded), y, z.
  void add(const Eigen::MatrixXf& rows, Eigen::Index first, Eigen::Index count);
  /// Writes field.shapes, and the scales into field.intake.
  void finish(CortexField& field);

 private:
  Eigen::Index points_;
  Eigen::MatrixXf values_;  // 3 points x modes
};

/// Rows of the field with padding, a multiple of 32.
Eigen::Index paddedRows(Eigen::Index points);

}  // namespace facenav::efield
