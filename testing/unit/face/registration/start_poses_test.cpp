#include "search/start_poses.h"

#include <gtest/gtest.h>

#include <random>

#include "model_field.h"

#include "facenav/geometry/rotation.h"

namespace facenav::registration {
namespace {

using facenav::testing::facing;
using facenav::testing::ModelHead;
using testing::modelField;

void expectRotation(const Eigen::Matrix3d& r) {
  EXPECT_LT((r.transpose() * r - Eigen::Matrix3d::Identity()).norm(), 1e-9);
  EXPECT_NEAR(r.determinant(), 1.0, 1e-9);
}

double nearest_deg(const std::vector<Eigen::Matrix3d>& tried, const Eigen::Matrix3d& wanted) {
  double least = 1e9;
  for (const auto& r : tried) least = std::min(least, rotationAngle(r.transpose() * wanted) / kRadPerDeg);
  return least;
}

/// camera_R_mri of a patient who looks `yaw` and `pitch` past the camera, by any `roll` of the camera.
Eigen::Matrix3d looking(double yaw_deg, double pitch_deg, double roll_deg) {
  const Eigen::Matrix3d facing_it = facing(0, 0, roll_deg).rotation();
  return facing_it * (Eigen::AngleAxisd(yaw_deg * kRadPerDeg, Eigen::Vector3d::UnitZ()) *
                      Eigen::AngleAxisd(pitch_deg * kRadPerDeg, Eigen::Vector3d::UnitX()))
                         .toRotationMatrix();
}

TEST(StartPoses, CoverEveryRollAndHeadsTurnedByFortyFiveDegrees) {
  const auto quick = facingOrientations(false), fine = facingOrientations(true);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> yaw(-45, 45), pitch(-25, 30), roll(0, 360);
  double worst_quick_deg = 0, worst_fine_deg = 0;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Matrix3d wanted = looking(yaw(random), pitch(random), roll(random));
    worst_quick_deg = std::max(worst_quick_deg, nearest_deg(quick, wanted));
    worst_fine_deg = std::max(worst_fine_deg, nearest_deg(fine, wanted));
  }
  // The fit finds the head from 30 degrees (aligner_test).
  EXPECT_LT(worst_quick_deg, 28);
  EXPECT_LT(worst_fine_deg, 20);
  for (const auto& r : fine) expectRotation(r);
}

TEST(StartPoses, NoneTriedHasTheFaceTurnedAway) {
  for (const bool is_fine : {false, true})
    for (const auto& camera_R_mri : facingOrientations(is_fine))
      EXPECT_LT((camera_R_mri * Eigen::Vector3d::UnitY()).z(), -0.3) << "anterior points to the camera";
}

TEST(StartPoses, AroundAPoseAreItselfFirstAndTurnsAboutTheHeadsAxes) {
  const Eigen::Matrix3d base = looking(20, -10, 70);
  const auto around = orientationsAround(base, 24.0);
  ASSERT_EQ(around.size(), 27u);
  EXPECT_TRUE(around.front() == base);
  for (const auto& r : around) {
    expectRotation(r);
    EXPECT_LT(rotationAngle(base.transpose() * r), 2 * 24.0 * kRadPerDeg);
  }
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-24.0, 24.0}) {
      const Eigen::Matrix3d turned =
          base * Eigen::AngleAxisd(side * kRadPerDeg, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
      EXPECT_LT(nearest_deg(around, turned), 1e-4) << axis << " " << side;
    }
}

TEST(StartPoses, HintsGiveTheOrientation) {
  const Eigen::Matrix3d truth = looking(15, -12, 130);
  AlignmentStart start;
  EXPECT_FALSE(hintedOrientation(start));
  start.patient_right = Direction<Camera>(truth.col(0));
  start.patient_superior = Direction<Camera>(truth.col(2));
  ASSERT_TRUE(hintedOrientation(start));
  EXPECT_LT(rotationAngle(truth.transpose() * *hintedOrientation(start)), 1e-6);
  // A right that is not perpendicular to superior is corrected; superior stays.
  start.patient_right = Direction<Camera>(truth.col(0) + 0.3 * truth.col(2));
  expectRotation(*hintedOrientation(start));
  EXPECT_LT((hintedOrientation(start)->col(2) - truth.col(2)).norm(), 1e-6);
  EXPECT_LT(rotationAngle(truth.transpose() * *hintedOrientation(start)), 1e-6);
}

TEST(StartPoses, OneHintIsCompletedByAPatientWhoLooksAtTheCamera) {
  for (const double roll_deg : {0.0, 100.0, 250.0}) {
    const Eigen::Matrix3d truth = looking(0, 0, roll_deg);
    AlignmentStart right, superior;
    right.patient_right = Direction<Camera>(truth.col(0));
    superior.patient_superior = Direction<Camera>(truth.col(2));
    for (const auto& start : {right, superior}) {
      const auto hinted = hintedOrientation(start);
      ASSERT_TRUE(hinted);
      expectRotation(*hinted);
      EXPECT_LT(rotationAngle(truth.transpose() * *hinted), 1e-6) << roll_deg;
    }
  }
}

TEST(StartPoses, HintsThatSayNothingAreNone) {
  AlignmentStart start;
  start.patient_superior = Direction<Camera>(Eigen::Vector3d(0, 0.1, -1));  // along the view: any roll
  EXPECT_FALSE(hintedOrientation(start));
  start.patient_right = start.patient_superior;  // right and up are parallel
  EXPECT_FALSE(hintedOrientation(start));
}

TEST(StartPoses, TheForemostSkinOfABallLiesTowardsTheCamera) {
  ModelHead ball;
  ball.bumps.clear();
  ball.radii_mm.setConstant(90);
  const ScalpField field(ball.skin(-70));
  for (const double turn_deg : {0.0, 40.0, -60.0}) {
    const Eigen::Vector3d towards = facenav::testing::towards(turn_deg, 15);
    // The mean of the nearest hundredth: a cap of some 12 degrees.
    EXPECT_LT((foremostSkin(field, towards) - 89 * towards).norm(), 6.0) << turn_deg;
  }
}

TEST(StartPoses, PlacedBringsThePointThere) {
  const Eigen::Matrix3d camera_R_mri = looking(30, 10, 200);
  const Eigen::Vector3d p_mri(10, 90, -20), p_camera(30, -40, 610);
  const Eigen::Isometry3d mri_T_camera = placed(camera_R_mri, p_mri, p_camera);
  EXPECT_LT((mri_T_camera * p_camera - p_mri).norm(), 1e-9);
  EXPECT_LT((mri_T_camera.linear().transpose() - camera_R_mri).norm(), 1e-9);
}

TEST(StartPoses, ACameraBehindTheHeadDoesNotSeeTheFace) {
  const Eigen::Vector3d middle = modelField().middle_mm();
  for (const double turn_deg : {0.0, 60.0, -75.0, 95.0, 180.0, -120.0}) {
    Eigen::Isometry3d mri_T_camera = Eigen::Isometry3d::Identity();
    mri_T_camera.translation() = middle + 600 * facenav::testing::towards(turn_deg, 0);
    EXPECT_EQ(seesTheFace(mri_T_camera, middle), std::abs(turn_deg) < 80) << turn_deg;
  }
}

}  // namespace
}  // namespace facenav::registration
