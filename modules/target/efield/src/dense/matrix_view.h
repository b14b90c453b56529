#pragma once
// MatrixView: a rectangular part of a matrix of floats with any strides, so that a transposed matrix is the
// same numbers with its strides exchanged.

#include <Eigen/Core>
#include <cstddef>

namespace facenav::efield::dense {

struct MatrixView {
  float* at = nullptr;
  std::ptrdiff_t rows = 0, columns = 0, row_step = 1, column_step = 0;

  MatrixView part(std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t row_count,
                  std::ptrdiff_t column_count) const {
    return {at + row * row_step + column * column_step, row_count, column_count, row_step, column_step};
  }
  MatrixView transposed() const { return {at, columns, rows, column_step, row_step}; }
  float& operator()(std::ptrdiff_t row, std::ptrdiff_t column) const {
    return at[row * row_step + column * column_step];
  }
};

/// The whole matrix. A view of a const matrix may only be read.
inline MatrixView viewOf(const Eigen::MatrixXf& matrix) {
  return {const_cast<float*>(matrix.data()), matrix.rows(), matrix.cols(), 1, matrix.rows()};
}

}  // namespace facenav::efield::dense
