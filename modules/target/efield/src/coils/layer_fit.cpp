#include "layer_fit.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace facenav::efield {

Eigen::VectorXd leastSquares(Eigen::MatrixXd matrix, const Eigen::VectorXd& wanted, double ridge) {
  const Eigen::VectorXd norms = matrix.colwise().norm().cwiseMax(1e-300);
  matrix.array().rowwise() /= norms.transpose().array();
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(matrix.cols(), matrix.cols());
  normal.selfadjointView<Eigen::Lower>().rankUpdate(matrix.transpose());
  normal.diagonal().array() += ridge;
  const Eigen::VectorXd right = matrix.transpose() * wanted;
  const Eigen::VectorXd scaled = normal.selfadjointView<Eigen::Lower>().ldlt().solve(right);
  return scaled.cwiseQuotient(norms);
}

Eigen::Matrix3Xd planePoints(const Eigen::Vector2d& low_mm, const Eigen::Vector2d& high_mm, double z_mm,
                             double spacing_mm) {
  const Eigen::Vector2d size_mm = high_mm - low_mm;
  const int columns = 1 + int(std::ceil(size_mm.x() / spacing_mm));
  const int rows = 1 + int(std::ceil(size_mm.y() / spacing_mm));
  Eigen::Matrix3Xd points(3, Eigen::Index(columns) * rows);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      points.col(i + Eigen::Index(columns) * j) << low_mm.x() + size_mm.x() * i / std::max(1, columns - 1),
          low_mm.y() + size_mm.y() * j / std::max(1, rows - 1), z_mm;
  return points;
}

}  // namespace facenav::efield
