#include "facenav/geometry/rotation.h"

#include <gtest/gtest.h>

#include <random>

#include "support/matchers.h"

namespace facenav {
namespace {

using testing::EigenNear;

TEST(Rotation, LogUndoesExpFromTinyToHalfATurn) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (const double angle_rad : {0.0, 1e-12, 1e-8, 1e-4, 0.1, 1.0, 3.0, M_PI - 1e-4, M_PI - 1e-7}) {
    const Eigen::Vector3d axis = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    EXPECT_THAT(logRotation(expRotation(angle_rad * axis)), EigenNear(angle_rad * axis, 1e-6)) << angle_rad;
  }
}

TEST(Rotation, ExpAgreesWithAngleAxis) {
  const Eigen::Vector3d w(0.3, -0.8, 0.5);
  const Eigen::Matrix3d expected = Eigen::AngleAxisd(w.norm(), w.normalized()).toRotationMatrix();
  EXPECT_LT((expRotation(w) - expected).norm(), 1e-14);
}

TEST(Rotation, AngleIsAccurateNearZero) {
  EXPECT_NEAR(rotationAngle(expRotation({0, 1e-9, 0})), 1e-9, 1e-15);
  EXPECT_NEAR(rotationAngle(expRotation({2, 0, 0})), 2, 1e-12);
}

TEST(Rotation, IncrementTurnsThenShifts) {
  Vector6d xi;
  xi << 0, 0, M_PI / 2, 1, 2, 3;
  EXPECT_THAT((expRigid(xi) * Eigen::Vector3d(1, 0, 0)).eval(), EigenNear(Eigen::Vector3d(1, 3, 3), 1e-12));
}

TEST(Rotation, SkewIsTheCrossProduct) {
  const Eigen::Vector3d a(1, -2, 3), b(4, 5, -6);
  EXPECT_THAT((skew(a) * b).eval(), EigenNear(a.cross(b), 1e-12));
}

}  // namespace
}  // namespace facenav
