#pragma once
// Solutions of symmetric systems, principal axes and small rotations. They are compiled here once: Eigen's
// decompositions are templates, and each file that uses one would spend seconds on it.

#include "facenav/geometry/rotation.h"

namespace facenav {
inline namespace geometry {

/// Solves A x = b for a symmetric A (LDLT with pivoting). The result is not finite if A is singular.
Eigen::Vector2d solveSymmetric(const Eigen::Matrix2d& a, const Eigen::Vector2d& b);
Eigen::Vector3d solveSymmetric(const Eigen::Matrix3d& a, const Eigen::Vector3d& b);
Eigen::Vector4d solveSymmetric(const Eigen::Matrix4d& a, const Eigen::Vector4d& b);
Vector6d solveSymmetric(const Matrix6d& a, const Vector6d& b);
Eigen::VectorXd solveSymmetric(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Inverse of a symmetric matrix (LDLT with pivoting). Not finite if the matrix is singular.
Eigen::Matrix4d inverseOfSymmetric(const Eigen::Matrix4d& a);
Eigen::MatrixXd inverseOfSymmetric(const Eigen::MatrixXd& a);
/// Inverse of a 6 x 6 matrix (LU with partial pivoting). Not finite if the matrix is singular.
Matrix6d inverseOf(const Matrix6d& a);

/// Eigenvalues of a symmetric matrix, smallest first, and their unit eigenvectors, as columns.
template <int n>
struct PrincipalAxes {
  Eigen::Matrix<double, n, 1> values;
  Eigen::Matrix<double, n, n> vectors;
};

PrincipalAxes<2> principalAxes(const Eigen::Matrix2d& symmetric);
PrincipalAxes<3> principalAxes(const Eigen::Matrix3d& symmetric);
PrincipalAxes<4> principalAxes(const Eigen::Matrix4d& symmetric);
PrincipalAxes<6> principalAxes(const Matrix6d& symmetric);
PrincipalAxes<Eigen::Dynamic> principalAxes(const Eigen::MatrixXd& symmetric);

/// The shortest rotation that turns the direction `from` into the direction `to`; lengths do not matter.
Eigen::Quaterniond rotationBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to);
/// The rotation nearest to a matrix, by the sum of squared differences (a sum of rotations gives their mean).
Eigen::Matrix3d nearestRotation(const Eigen::Matrix3d& matrix);

}  // namespace geometry
}  // namespace facenav
