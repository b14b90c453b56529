#include "facenav/geometry/median_pose.h"

#include <gtest/gtest.h>

#include <random>

#include "facenav/geometry/rotation.h"

namespace facenav {
namespace {

TEST(MedianPose, OfThreePointsOnALineIsTheMiddleOne) {
  const Eigen::Vector3d median = medianPoint({{0, 0, 0}, {1, 0, 0}, {50, 0, 0}});
  EXPECT_NEAR((median - Eigen::Vector3d(1, 0, 0)).norm(), 0, 1e-3);
}

TEST(MedianPose, FewerThanHalfCannotMoveItFar) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.1);
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Matrix3d> rotations;
  for (int i = 0; i < 60; ++i) {
    const bool is_wrong = i % 3 == 0;
    const Eigen::Vector3d error(noise(random), noise(random), noise(random));
    points.push_back(Eigen::Vector3d(10, 20, 30) + (is_wrong ? Eigen::Vector3d(40, 0, 0) : error));
    rotations.push_back(expRotation(is_wrong ? Eigen::Vector3d(0.6, 0, 0) : Eigen::Vector3d(0.05 * error)));
  }
  EXPECT_LT((medianPoint(points) - Eigen::Vector3d(10, 20, 30)).norm(), 0.25) << "the mean is 13 mm off";
  EXPECT_LT(rotationAngle(medianRotation(rotations)) * kDegPerRad, 0.7) << "the mean is 11 deg off";
}

TEST(MedianPose, OfOneIsItself) {
  const Eigen::Matrix3d turn = expRotation({0.1, -0.7, 2.0});
  EXPECT_LT(rotationAngle(turn.transpose() * medianRotation({turn})), 1e-9);
  EXPECT_EQ(medianPoint({{1, 2, 3}}), Eigen::Vector3d(1, 2, 3));
}

}  // namespace
}  // namespace facenav
