#pragma once
// Least squares of few dipoles: finds the moments whose observations agree best with given ones.

#include <Eigen/Core>

namespace facenav::efield {

/// Solves min |matrix x - wanted|^2 + ridge |x|^2 by the normal equations, columns scaled to unit length.
/// `ridge`: relative to the scaled columns.
Eigen::VectorXd leastSquares(Eigen::MatrixXd matrix, const Eigen::VectorXd& wanted, double ridge);

/// Points of a plane, x and y from `low` to `high` at most `spacing_mm` apart.
Eigen::Matrix3Xd planePoints(const Eigen::Vector2d& low_mm, const Eigen::Vector2d& high_mm, double z_mm,
                             double spacing_mm);

}  // namespace facenav::efield
