#include "facenav/geometry/normal_equations.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

namespace facenav {
inline namespace geometry {

Eigen::Vector2d solveSymmetric(const Eigen::Matrix2d& a, const Eigen::Vector2d& b) {
  return a.ldlt().solve(b);
}

Eigen::Vector3d solveSymmetric(const Eigen::Matrix3d& a, const Eigen::Vector3d& b) {
  return a.ldlt().solve(b);
}

Eigen::Vector4d solveSymmetric(const Eigen::Matrix4d& a, const Eigen::Vector4d& b) {
  return a.ldlt().solve(b);
}

Vector6d solveSymmetric(const Matrix6d& a, const Vector6d& b) { return a.ldlt().solve(b); }

Eigen::VectorXd solveSymmetric(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.ldlt().solve(b);
}

Eigen::Matrix4d inverseOfSymmetric(const Eigen::Matrix4d& a) {
  return a.ldlt().solve(Eigen::Matrix4d::Identity());
}

Eigen::MatrixXd inverseOfSymmetric(const Eigen::MatrixXd& a) {
  return a.ldlt().solve(Eigen::MatrixXd::Identity(a.rows(), a.cols()));
}

Matrix6d inverseOf(const Matrix6d& a) { return a.inverse(); }

Eigen::Quaterniond rotationBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  // Not Eigen's FromTwoVectors: its singular values take ten seconds to compile.
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  const double cosine = a.dot(b);
  if (cosine < -1.0 + 1e-12) {  // opposite: half a turn about any axis across
    const Eigen::Vector3d axis = a.unitOrthogonal();
    return {0.0, axis.x(), axis.y(), axis.z()};
  }
  const double twice_w = std::sqrt(2.0 * (1.0 + cosine));
  const Eigen::Vector3d v = a.cross(b) / twice_w;
  return {0.5 * twice_w, v.x(), v.y(), v.z()};
}

Eigen::Matrix3d nearestRotation(const Eigen::Matrix3d& matrix) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d signs(1, 1, (svd.matrixU() * svd.matrixV().transpose()).determinant());
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace geometry
}  // namespace facenav
