#include "facenav/geometry/rigid_transform.h"

#include <gtest/gtest.h>

#include "support/matchers.h"

namespace facenav {
namespace {

using testing::EigenNear;
using testing::PoseNear;

using CameraFromMri = RigidTransform<Camera, Mri>;
using MriFromTarget = RigidTransform<Mri, Target>;
using TargetFromCoil = RigidTransform<Target, Coil>;

// A wrong chain must not compile.
static_assert(composes<CameraFromMri, MriFromTarget>::value, "adjacent frames cancel");
static_assert(composes<CameraFromMri, Point<Mri>>::value, "points of the inner frame are mapped");
static_assert(!composes<MriFromTarget, CameraFromMri>::value, "reversed order");
static_assert(!composes<CameraFromMri, TargetFromCoil>::value, "frames that do not meet");
static_assert(!composes<CameraFromMri, CameraFromMri>::value, "the same transform twice");
static_assert(!composes<CameraFromMri, Point<Camera>>::value, "a point already in the outer frame");

CameraFromMri some() {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 3).normalized())), {10, -20, 600}};
}

TEST(RigidTransform, InverseUndoesTransform) {
  const Point<Mri> p(12, -34, 56);
  EXPECT_THAT((some().inverse() * (some() * p)).mm, EigenNear(p.mm, 1e-12));
  EXPECT_THAT((some() * some().inverse()), PoseNear((RigidTransform<Camera, Camera>()), 1e-9, 1e-9));
}

TEST(RigidTransform, ChainMapsAsItsLinksInTurn) {
  const MriFromTarget mri_T_target(Eigen::Quaterniond(Eigen::AngleAxisd(-0.3, Eigen::Vector3d::UnitY())),
                                   {1, 2, 3});
  const Point<Target> p(5, 6, 7);
  EXPECT_THAT(((some() * mri_T_target) * p).mm, EigenNear((some() * (mri_T_target * p)).mm, 1e-12));
}

TEST(RigidTransform, QuarterTurnAboutZByHand) {
  const CameraFromMri turn(Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ())),
                           {0, 0, 5});
  EXPECT_THAT((turn * Point<Mri>(1, 0, 0)).mm, EigenNear(Eigen::Vector3d(0, 1, 5), 1e-12));
  EXPECT_THAT((turn * Direction<Mri>(Eigen::Vector3d(1, 0, 0))).v,
              EigenNear(Eigen::Vector3d(0, 1, 0), 1e-12));
}

TEST(RigidTransform, MirroredMatrixIsRefused) {
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Matrix4d flipped = some().matrix();
    flipped.col(axis) *= -1;  // for instance left and right swapped
    EXPECT_THROW(CameraFromMri::fromMatrix(flipped), Error);
  }
}

TEST(RigidTransform, ScaledShearedAndProjectiveMatricesAreRefused) {
  Eigen::Matrix4d scaled = some().matrix();
  scaled.topLeftCorner<3, 3>() *= 1000;  // metres read as millimetres
  EXPECT_THROW(CameraFromMri::fromMatrix(scaled), Error);
  Eigen::Matrix4d sheared = some().matrix();
  sheared(0, 1) += 0.1;
  EXPECT_THROW(CameraFromMri::fromMatrix(sheared), Error);
  Eigen::Matrix4d projective = some().matrix();
  projective(3, 0) = 0.1;
  EXPECT_THROW(CameraFromMri::fromMatrix(projective), Error);
  Eigen::Matrix4d unknown = some().matrix();
  unknown(1, 3) = std::nan("");
  EXPECT_THROW(CameraFromMri::fromMatrix(unknown), Error);
}

TEST(RigidTransform, MatrixWithFileDigitsIsTakenAndMadeOrthonormal) {
  Eigen::Matrix4d rounded = (some().matrix() * 1e4).array().round() / 1e4;
  rounded(3, 3) = 1;
  const auto read = CameraFromMri::fromMatrix(rounded);
  EXPECT_THAT(read, PoseNear(some(), 0.01, 1e-3));
  EXPECT_LT((read.rotation().transpose() * read.rotation() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
}

TEST(RigidTransform, QuaternionHasPositiveRealPart) {
  const CameraFromMri turned(Eigen::Quaterniond(-0.5, 0.5, 0.5, 0.5), {0, 0, 0});
  EXPECT_GE(turned.quaternion().w(), 0.0);
}

TEST(PoseError, KnownAngleAndShift) {
  const CameraFromMri truth;
  const CameraFromMri estimate(Eigen::Quaterniond(Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitX())),
                               {3, 4, 0});
  const PoseError error = poseError(estimate, truth, Point<Mri>(0, 100, 0));
  EXPECT_NEAR(error.rotation_rad, 0.01, 1e-12);
  EXPECT_NEAR(error.translation_mm, 5, 1e-12);
  // (3, 4 + 100 cos 0.01 - 100, 100 sin 0.01)
  EXPECT_NEAR(error.at_point_mm,
              Eigen::Vector3d(3, 4 + 100 * (std::cos(0.01) - 1), 100 * std::sin(0.01)).norm(), 1e-9);
}

}  // namespace
}  // namespace facenav
