#include "facenav/geometry/interpolate.h"

#include <gtest/gtest.h>

#include "support/matchers.h"

namespace facenav {
namespace {

using testing::PoseNear;
using Pose = RigidTransform<Camera, Coil>;

Pose turned(double angle_rad, const Eigen::Vector3d& place_mm) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, Eigen::Vector3d(1, 2, 2).normalized())), place_mm};
}

TEST(Interpolate, EndsAreTheGivenPoses) {
  const Pose a = turned(0.3, {1, 2, 3}), b = turned(-0.4, {9, -2, 7});
  EXPECT_THAT(interpolated(a, b, 0.0), PoseNear(a, 1e-12, 1e-12));
  EXPECT_THAT(interpolated(a, b, 1.0), PoseNear(b, 1e-12, 1e-12));
}

TEST(Interpolate, SteadyMotionIsMetInBetween) {
  const Pose a = turned(0.1, {0, 0, 500}), b = turned(0.5, {8, -4, 520});
  EXPECT_THAT(interpolated(a, b, 0.25), PoseNear(turned(0.2, {2, -1, 505}), 1e-9, 1e-9));
}

TEST(Interpolate, GoesTheShorterWayRound) {
  const Eigen::Vector3d place_mm(4, 5, 6);
  const Pose a = turned(3.0, place_mm), b = turned(-3.0, place_mm);  // 0.28 rad apart, through pi
  EXPECT_THAT(interpolated(a, b, 0.5), PoseNear(turned(M_PI, place_mm), 1e-9, 1e-9));
}

}  // namespace
}  // namespace facenav
