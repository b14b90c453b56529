#include "facenav/efield/local_sphere.h"

#include <gtest/gtest.h>

#include <cmath>

#include "facenav/core/error.h"

namespace facenav::efield {
namespace {

/// Points all over an ellipsoid about `centre`.
std::vector<Eigen::Vector3d> ellipsoid(const Eigen::Vector3d& centre_mm, const Eigen::Vector3d& axes_mm) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 4000; ++i) {
    const double z = 1 - 2 * (i + 0.5) / 4000, angle = 2.399963 * i, r = std::sqrt(1 - z * z);
    points.push_back(centre_mm +
                     Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z).cwiseProduct(axes_mm));
  }
  return points;
}

TEST(LocalSphere, IsTheSphereItself) {
  const Eigen::Vector3d centre(3, -20, 15);
  const auto sphere = localSphere(ellipsoid(centre, {85, 85, 85}), centre + Eigen::Vector3d(0, 40, 85));
  EXPECT_NEAR((sphere.centre_mm - centre).norm(), 0, 1e-8);
  EXPECT_NEAR(sphere.radius_mm, 85, 1e-8);
  EXPECT_TRUE(sphere.is_local);
}

TEST(LocalSphere, FollowsTheCurvatureUnderTheCoil) {
  const auto points = ellipsoid({0, 0, 0}, {70, 90, 80});
  const auto side = localSphere(points, {78, 0, 0}), top = localSphere(points, {0, 0, 88});
  // A head's side is flatter than its ends: its sphere is larger and its centre deeper.
  EXPECT_LT(side.centre_mm.x(), -5);
  EXPECT_GT(side.radius_mm, 75);
  EXPECT_NEAR(side.centre_mm.y(), 0, 0.5);
  EXPECT_NEAR(top.centre_mm.head<2>().norm(), 0, 0.5);
}

TEST(LocalSphere, TakesAllPointsWhereFewAreNear) {
  const auto far = localSphere(ellipsoid({0, 0, 0}, {80, 80, 80}), {0, 0, 170});
  EXPECT_FALSE(far.is_local);
  EXPECT_NEAR(far.radius_mm, 80, 1e-8);
}

TEST(LocalSphere, RefusesWhatIsNoHead) {
  EXPECT_THROW(localSphere({}, {0, 0, 0}), Error);
  EXPECT_THROW(localSphere(ellipsoid({0, 0, 0}, {9, 9, 9}), {0, 0, 9}), Error);
}

}  // namespace
}  // namespace facenav::efield
