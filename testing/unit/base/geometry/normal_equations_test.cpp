#include "facenav/geometry/normal_equations.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

namespace facenav {
namespace {

Matrix6d knownMatrix() {
  Matrix6d a;
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c) a(r, c) = 1.0 / (1 + r + c) + (r == c ? 2.0 + r : 0.0);
  return a;
}

TEST(NormalEquations, SolutionGivesTheRightSide) {
  const Vector6d b = (Vector6d() << 3, -1, 4, 1, -5, 9).finished();
  EXPECT_LT((knownMatrix() * solveSymmetric(knownMatrix(), b) - b).norm(), 1e-12);
  const Eigen::VectorXd x = solveSymmetric(Eigen::MatrixXd(knownMatrix()), Eigen::VectorXd(b));
  ASSERT_EQ(x.size(), 6);
  EXPECT_LT((knownMatrix() * x - b).norm(), 1e-12);
}

TEST(NormalEquations, InverseTimesTheMatrixIsTheUnit) {
  EXPECT_LT((inverseOf(knownMatrix()) * knownMatrix() - Matrix6d::Identity()).norm(), 1e-12);
}

TEST(NormalEquations, EigenvaluesComeSmallestFirst) {
  Vector6d values;
  values << 7, -2, 5, 0, 3, 11;
  const Matrix6d turn = Eigen::HouseholderQR<Matrix6d>(knownMatrix()).householderQ();
  const Matrix6d matrix = turn * values.asDiagonal() * turn.transpose();
  const PrincipalAxes<6> axes = principalAxes(matrix);
  EXPECT_LT((axes.vectors * axes.values.asDiagonal() * axes.vectors.transpose() - matrix).norm(), 1e-11);
  EXPECT_LT((axes.values - (Vector6d() << -2, 0, 3, 5, 7, 11).finished()).norm(), 1e-12);
}

TEST(NearestRotation, IsTheMeanOfTurnsAboutOneAxis) {
  const auto turn = [](double angle_rad) { return expRotation(Eigen::Vector3d(0.6, 0, 0.8) * angle_rad); };
  EXPECT_LT((nearestRotation(turn(0.1) + turn(0.5)) - turn(0.3)).norm(), 1e-12);
  const Eigen::Matrix3d mirror = Eigen::Vector3d(1, 1, -0.5).asDiagonal();
  EXPECT_NEAR(nearestRotation(mirror).determinant(), 1.0, 1e-12) << "never a mirror image";
}

TEST(RotationBetween, TurnsOneDirectionIntoTheOther) {
  const Eigen::Vector3d from(1, 2, -3), to(-4, 0.5, 2);
  const Eigen::Quaterniond turn = rotationBetween(from, to);
  EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 1e-12);
  const double angle_rad = std::acos(from.normalized().dot(to.normalized()));
  EXPECT_NEAR(Eigen::AngleAxisd(turn).angle(), angle_rad, 1e-12) << "no turn about the direction itself";
}

TEST(RotationBetween, OppositeDirectionsTurnByHalfATurn) {
  const Eigen::Quaterniond turn = rotationBetween(Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitZ());
  EXPECT_LT((turn * Eigen::Vector3d::UnitZ() + Eigen::Vector3d::UnitZ()).norm(), 1e-9);
}

}  // namespace
}  // namespace facenav
