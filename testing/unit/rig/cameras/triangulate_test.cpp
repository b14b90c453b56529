#include <gtest/gtest.h>

#include <random>

#include "facenav/cameras/stereo_rig.h"
#include "support/matchers.h"
#include "support/stereo_rigs.h"

using namespace facenav;
using namespace facenav::cameras;
using facenav::testing::EigenNear;
namespace rigs = facenav::testing;

namespace {

std::pair<Eigen::Vector2d, Eigen::Vector2d> seen(const StereoRig& rig, const Eigen::Vector3d& p) {
  return {project(rig.left, p), project(rig.right, rig.right_T_left.isometry() * p)};
}

}  // namespace

TEST(Triangulate, RecoversThePointSeen) {
  for (const StereoRig& rig :
       {rigs::convergingRig(), rigs::verticalRig(), rigs::rolledRig(), rigs::fullyDistortedRig()})
    for (const Eigen::Vector3d& p : {Eigen::Vector3d(20, 30, 600), {-60, 40, 450}, {80, -50, 900}}) {
      const auto [left, right] = seen(rig, p);
      EXPECT_THAT(triangulate(rig, left, right).mm, EigenNear(p, 1e-5));
      EXPECT_LT(epipolarError_px(rig, left, right), 1e-6);
    }
}

TEST(Triangulate, HasTheLeastReprojectionError) {
  const StereoRig rig = rigs::convergingRig();
  auto [left, right] = seen(rig, {15, -25, 620});
  left += Eigen::Vector2d(0.4, -0.7);
  right += Eigen::Vector2d(-0.3, 0.8);
  const Eigen::Vector3d best = triangulate(rig, left, right).mm;
  const auto cost = [&](const Eigen::Vector3d& p) {
    const auto [l, r] = seen(rig, p);
    return (l - left).squaredNorm() + (r - right).squaredNorm();
  };
  for (int axis = 0; axis < 3; ++axis)
    for (double step_mm : {-0.05, 0.05})
      EXPECT_GT(cost(best + step_mm * Eigen::Vector3d::Unit(axis)), cost(best));
}

TEST(Triangulate, EpipolarErrorIsTheDistanceInPixels) {
  const StereoRig rig = rigs::convergingRig();
  auto [left, right] = seen(rig, {0, 0, 600});
  right.y() += 2.0;  // epipolar lines are nearly horizontal here
  EXPECT_NEAR(epipolarError_px(rig, left, right), 2.0, 0.1);
}

TEST(Triangulate, RaysThatDivergeGiveAFinitePoint) {
  const StereoRig rig = rigs::convergingRig();
  const Eigen::Vector3d p = triangulate(rig, {50, 240}, {600, 240}).mm;
  EXPECT_TRUE(p.allFinite());
}
