#include "fit/field_fit.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "facenav/geometry/pose_error.h"
#include "model_field.h"

#include "facenav/geometry/rotation.h"

namespace facenav::registration {
namespace {

using facenav::testing::facing;
using testing::allOf;
using testing::modelFace;
using testing::modelField;
using testing::modelHead;

Vector6d off(double turn_deg, double shift_mm) {
  Vector6d xi;
  xi << turn_deg * kRadPerDeg * Eigen::Vector3d(0.6, -0.5, 0.62).normalized(),
      shift_mm * Eigen::Vector3d(-0.4, 0.7, 0.59).normalized();
  return xi;
}

double apart_mm(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b,
                const Eigen::Vector3d& at_mri_mm = {-40, -10, 60}) {
  return (a * b.inverse() * at_mri_mm - at_mri_mm).norm();
}

TEST(Increment, TurnsAboutThePivotAndThenShifts) {
  const Eigen::Vector3d pivot(10, 20, 30);
  const Eigen::Isometry3d pose = facing(5, 3, 1).isometry().inverse();
  Vector6d turn = Vector6d::Zero();
  turn[2] = 90 * kRadPerDeg;
  const Eigen::Vector3d p_camera = pose.inverse() * pivot;
  EXPECT_LT((increment(turn, pivot, pose) * p_camera - pivot).norm(), 1e-9) << "the pivot stays";
  const Eigen::Vector3d beside = pose.inverse() * (pivot + Eigen::Vector3d(1, 0, 0));
  EXPECT_LT((increment(turn, pivot, pose) * beside - (pivot + Eigen::Vector3d(0, 1, 0))).norm(), 1e-9);
  Vector6d shift = Vector6d::Zero();
  shift.tail<3>() << 1, 2, 3;
  EXPECT_LT((increment(shift, pivot, pose) * beside - (pivot + Eigen::Vector3d(2, 2, 3))).norm(), 1e-9);
}

TEST(AreDistinct, AsksForTheTurnAndForTheShiftAtThePivotAlone) {
  const Eigen::Isometry3d a = facing(5, 3, 1).isometry().inverse();
  const Eigen::Vector3d pivot(0, 0, 20), far(0, 0, 1020);
  Vector6d turn = Vector6d::Zero();
  turn[0] = 3 * kRadPerDeg;
  const Eigen::Isometry3d b = increment(turn, pivot, a);
  EXPECT_FALSE(areDistinct(a, b, pivot, 3.01 * kRadPerDeg, 1e-6));
  EXPECT_TRUE(areDistinct(a, b, pivot, 2.99 * kRadPerDeg, 1e-6));
  EXPECT_TRUE(areDistinct(a, b, far, 3.01 * kRadPerDeg, 50.0)) << "a metre away that turn shifts by 52 mm";
  EXPECT_FALSE(areDistinct(a, b, far, 3.01 * kRadPerDeg, 53.0));
}

TEST(TukeyWeight, IsOneAtNothingAndNothingFromTheLimitOn) {
  EXPECT_EQ(tukeyWeight(0, 2), 1.0f);
  EXPECT_NEAR(tukeyWeight(1, 2), 9.0f / 16, 1e-6);
  EXPECT_EQ(tukeyWeight(2, 2), 0.0f);
  EXPECT_EQ(tukeyWeight(-3, 2), 0.0f);
  EXPECT_EQ(tukeyWeight(std::numeric_limits<float>::infinity(), 2), 0.0f);
}

TEST(FieldFitter, FindsThePoseFromEightMillimetresAndFourDegreesOff) {
  const auto truth = facing(12, -6, 20);
  const auto cloud = modelFace(truth);
  const FieldFitter fitter(modelField(), cloud, allOf(cloud));
  const Eigen::Isometry3d right = truth.isometry().inverse();
  Eigen::Isometry3d pose = increment(off(4, 8), modelField().middle_mm(), right);
  ASSERT_GT(apart_mm(pose, right), 2.5);
  for (const float reach_mm : {20.f, 8.f, 3.f, 1.5f})
    pose = fitter.fit(pose, {reach_mm, reach_mm, 8, reach_mm < 4});
  EXPECT_LT(apart_mm(pose, right), 0.1);
  EXPECT_LT(rotationAngle((pose * right.inverse()).linear()), 0.05 * kRadPerDeg);
}

TEST(FieldFitter, ResidualsArePositiveOutsideTheSkin) {
  const auto truth = facing(0, 0, 0);
  auto cloud = modelFace(truth, 2000, 0.0);
  const Eigen::Isometry3d mri_T_camera = truth.isometry().inverse();
  // A point nearer to the camera lies outside of skin that faces it.
  for (auto& p : cloud.points_mm) p -= 1.0 * p.normalized();
  int outside = 0, valid = 0;
  for (const PointMatch& match : FieldFitter(modelField(), cloud, allOf(cloud)).match(mri_T_camera)) {
    if (!match.is_valid) continue;
    ++valid;
    outside += match.residual_mm > 0.2f && match.residual_mm < 1.1f;  // 1 mm along the ray, cos > 0.3
    EXPECT_NEAR(match.normal_mri.norm(), 1.0f, 1e-4f);
  }
  EXPECT_GT(valid, 1900);
  EXPECT_GT(outside, 0.98 * valid);
}

TEST(FieldFitter, PointsWithoutWeightDoNotPull) {
  const auto truth = facing(-10, 4, 0);
  auto cloud = modelFace(truth);
  const Eigen::Isometry3d right = truth.isometry().inverse();
  // The patient's right half is shifted by 1.5 mm towards the camera.
  std::vector<float> weights(cloud.size(), 1.0f);
  for (std::size_t p = 0; p < cloud.size(); ++p)
    if ((right * cloud.points_mm[p]).x() > 5) {
      cloud.points_mm[p] -= 1.5 * cloud.points_mm[p].normalized();
      weights[p] = 0.0f;
    }
  FieldFitter fitter(modelField(), cloud, allOf(cloud));
  const FitStage stage{4, 4, 15, true};
  const Eigen::Vector3d cheek(40, 80, 20);
  const double pulled_mm = apart_mm(fitter.fit(right, stage), right, cheek);
  fitter.setWeights(weights);
  EXPECT_LT(apart_mm(fitter.fit(right, stage), right, cheek), 0.15);
  EXPECT_GT(pulled_mm, 0.5);
}

TEST(FieldFitter, WhatASphereDoesNotFixStays) {
  facenav::testing::ModelHead ball;
  ball.bumps.clear();
  ball.radii_mm.setConstant(90);
  const ScalpField field(ball.skin(-60));
  const auto truth = facing(0, 0, 0);
  const auto cloud = facenav::testing::measure(ball, truth, {0.0, false, false, -50, 200, 3000, 5});
  const FieldFitter fitter(field, cloud, allOf(cloud));
  const Eigen::Isometry3d right = truth.isometry().inverse();
  // The ball's middle is not the box's, so that turns are about the ball's own.
  Vector6d turn = Vector6d::Zero();
  turn[2] = 10 * kRadPerDeg;
  const Eigen::Isometry3d turned = increment(turn, Eigen::Vector3d::Zero(), right);
  const Eigen::Isometry3d fitted = fitter.fit(turned, {6, 6, 10, true});
  EXPECT_LT(rotationAngle((fitted * turned.inverse()).linear()), 0.3 * kRadPerDeg);
  EXPECT_LT((fitted * turned.inverse() * Eigen::Vector3d::Zero()).norm(), 0.1);
}

TEST(FieldFitter, TheCostIsTheTruncationWhereThereIsNoSkinAndNothingWhereAllFits) {
  const auto truth = facing(0, 0, 0);
  const auto cloud = modelFace(truth, 3000, 0.0);
  const FieldFitter fitter(modelField(), cloud, allOf(cloud));
  const Eigen::Isometry3d right = truth.isometry().inverse();
  EXPECT_LT(fitter.cost(right, 4.0), 1.0);
  Eigen::Isometry3d away = right;
  away.translation() += Eigen::Vector3d(0, 400, 0);  // before the face, in the air
  EXPECT_NEAR(fitter.cost(away, 4.0), 16.0, 1e-6);
  std::vector<int> middle;
  for (int p = 0; p < int(cloud.size()); ++p) {
    const Eigen::Vector3d at = right * cloud.points_mm[std::size_t(p)];
    if (std::abs(at.x()) < 25 && at.z() > -10 && at.z() < 45) middle.push_back(p);
  }
  Eigen::Isometry3d inside = right;
  inside.translation() -= Eigen::Vector3d(0, 40, 0);
  EXPECT_NEAR(FieldFitter(modelField(), cloud, middle).cost(inside, 4.0), 1.3 * 16, 0.1) << "deep inside";
  EXPECT_EQ(FieldFitter(modelField(), cloud, {}).cost(right, 4.0), 16.0) << "no points";
}

TEST(FieldFitter, PointsThatAreTooFewMoveNothing) {
  const auto truth = facing(0, 0, 0);
  const auto cloud = modelFace(truth, 10);
  const FieldFitter fitter(modelField(), cloud, allOf(cloud));
  const Eigen::Isometry3d start = increment(off(1, 2), modelField().middle_mm(), truth.isometry().inverse());
  EXPECT_TRUE(fitter.fit(start, {8, 8, 10, true}).matrix() == start.matrix());
}

TEST(FieldFitter, WithinCountsBothSidesOfTheSkin) {
  const auto truth = facing(0, 0, 0);
  auto cloud = modelFace(truth, 900, 0.0);
  for (std::size_t p = 0; p < cloud.size(); ++p) {
    const double by_mm = p % 3 == 0 ? 0.0 : (p % 3 == 1 ? 25.0 : -25.0);
    cloud.points_mm[p] += by_mm * cloud.points_mm[p].normalized();
  }
  const FieldFitter fitter(modelField(), cloud, allOf(cloud));
  std::array<int, 3> found{};
  for (const int p : fitter.within(truth.isometry().inverse(), 3.0)) ++found[std::size_t(p) % 3];
  EXPECT_GT(found[0], 295);
  EXPECT_LT(found[1] + found[2], 15) << "25 mm along a ray is 7 mm and more from the skin, but for the nose";
}

}  // namespace
}  // namespace facenav::registration
