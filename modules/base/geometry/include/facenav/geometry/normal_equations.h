#pragma once
// Solutions of symmetric systems, principal axes and small rotations. They stand here once because Eigen's
// decompositions are templates: each file that names one compiles it again, for seconds.

#include "facenav/geometry/rotation.h"

namespace facenav {
inline namespace geometry {

/// x of A x = b, A symmetric (LDLT with pivoting). Not finite where A is singular.
Eigen::Vector2d solveSymmetric(const Eigen::Matrix2d& a, const Eigen::Vector2d& b);
Eigen::Vector3d solveSymmetric(const Eigen::Matrix3d& a, const Eigen::Vector3d& b);
Eigen::Vector4d solveSymmetric(const Eigen::Matrix4d& a, const Eigen::Vector4d& b);
Vector6d solveSymmetric(const Matrix6d& a, const Vector6d& b);
Eigen::VectorXd solveSymmetric(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// A^-1, A symmetric (LDLT with pivoting). Not finite where A is singular.
Eigen::Matrix4d inverseOfSymmetric(const Eigen::Matrix4d& a);
Eigen::MatrixXd inverseOfSymmetric(const Eigen::MatrixXd& a);
/// A^-1 of a 6 x 6 matrix (LU with partial pivoting). Not finite where A is singular.
Matrix6d inverseOf(const Matrix6d& a);

/// Eigenvalues of a symmetric matrix, smallest first, and the unit vectors that belong to them, as columns.
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
