#include <Eigen/Eigenvalues>

#include "facenav/geometry/normal_equations.h"

namespace facenav {
inline namespace geometry {
namespace {

template <int n>
PrincipalAxes<n> axesOf(const Eigen::Matrix<double, n, n>& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, n, n>> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace

PrincipalAxes<2> principalAxes(const Eigen::Matrix2d& symmetric) { return axesOf<2>(symmetric); }
PrincipalAxes<3> principalAxes(const Eigen::Matrix3d& symmetric) { return axesOf<3>(symmetric); }
PrincipalAxes<4> principalAxes(const Eigen::Matrix4d& symmetric) { return axesOf<4>(symmetric); }
PrincipalAxes<6> principalAxes(const Matrix6d& symmetric) { return axesOf<6>(symmetric); }

PrincipalAxes<Eigen::Dynamic> principalAxes(const Eigen::MatrixXd& symmetric) {
  return axesOf<Eigen::Dynamic>(symmetric);
}

}  // namespace geometry
}  // namespace facenav
