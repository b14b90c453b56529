#include "facenav/geometry/rigid_fit.h"

#include <gtest/gtest.h>

#include <random>

#include "support/matchers.h"

namespace facenav {
namespace {

using testing::PoseNear;

RigidTransform<Camera, Mri> truth() {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(2.6, Eigen::Vector3d(3, -1, 2).normalized())), {40, -7, 612}};
}

PointCloud<Mri> cloud(int count, double flatness = 1.0) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> mm(-80, 80);
  PointCloud<Mri> points;
  for (int i = 0; i < count; ++i)
    points.points_mm.emplace_back(mm(random), mm(random), flatness * mm(random));
  return points;
}

TEST(FitRigid, RecoversTheKnownTransform) {
  for (const int count : {3, 7, 200})
    EXPECT_THAT(fitRigid(cloud(count), truth() * cloud(count)), PoseNear(truth(), 1e-6, 1e-9));
}

TEST(FitRigid, CoplanarPointsGiveARotationNotAMirror) {
  const auto fit = fitRigid(cloud(9, 0.0), truth() * cloud(9, 0.0));
  EXPECT_NEAR(fit.rotation().determinant(), 1, 1e-12);
  EXPECT_THAT(fit, PoseNear(truth(), 1e-6, 1e-9));
}

TEST(FitRigid, MirroredPointsStillGiveARotation) {
  PointCloud<Camera> mirrored = truth() * cloud(50);
  for (auto& p_mm : mirrored.points_mm) p_mm.x() *= -1;
  const auto fit = fitRigidPoints(cloud(50).points_mm, mirrored.points_mm);
  EXPECT_NEAR(fit.to_T_from.linear().determinant(), 1, 1e-12);
  EXPECT_GT(fit.rms_mm, 10);  // the residual shows that the fit is bad
}

TEST(FitRigid, WeightZeroTakesAPointOut) {
  auto moved = truth() * cloud(8);
  std::vector<double> weights(8, 1.0);
  moved.points_mm[3] += Eigen::Vector3d(30, 0, 0);
  weights[3] = 0;
  EXPECT_THAT(fitRigid(cloud(8), moved, weights), PoseNear(truth(), 1e-6, 1e-9));
}

TEST(FitRigid, ResidualOfAKnownDisturbance) {
  // Opposite shifts of +-1 mm along one line of a symmetric cross do not change the pose and give a known
  // residual.
  const std::vector<Eigen::Vector3d> from{{10, 0, 0}, {-10, 0, 0}, {0, 10, 0}, {0, -10, 0}};
  std::vector<Eigen::Vector3d> to = from;
  to[0].x() += 1;
  to[1].x() -= 1;
  const auto fit = fitRigidPoints(from, to);
  EXPECT_LT((fit.to_T_from.matrix() - Eigen::Matrix4d::Identity()).norm(), 1e-12);
  EXPECT_NEAR(fit.rms_mm, std::sqrt(2.0 / 4.0), 1e-12);
}

TEST(FitRigid, RefusesTooFewOrCollinearPoints) {
  EXPECT_THROW(fitRigid(cloud(2), truth() * cloud(2)), Error);
  EXPECT_THROW(fitRigidPoints({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}), Error);
  EXPECT_THROW(fitRigid(cloud(5), truth() * cloud(5), {1, 1, 0, 0, 0}), Error);
}

}  // namespace
}  // namespace facenav
