#include "facenav/geometry/nearest_on_triangle.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "support/matchers.h"

namespace facenav {
namespace {

using Eigen::Vector3d;
using testing::EigenNear;

const Vector3d kA(0, 0, 0), kB(4, 0, 0), kC(0, 3, 0);

TEST(NearestOnTriangle, OfEachRegionIsTheKnownPoint) {
  const auto nearest = [](const Vector3d& p) { return nearestOnTriangle(p, kA, kB, kC).point; };
  EXPECT_THAT(nearest({-1, -2, 5}), EigenNear(kA, 1e-12));
  EXPECT_THAT(nearest({6, -1, 1}), EigenNear(kB, 1e-12));
  EXPECT_THAT(nearest({-1, 5, -2}), EigenNear(kC, 1e-12));
  EXPECT_THAT(nearest({2, -1, 3}), EigenNear(Vector3d(2, 0, 0), 1e-12));
  EXPECT_THAT(nearest({-2, 1, 3}), EigenNear(Vector3d(0, 1, 0), 1e-12));
  EXPECT_THAT(nearest({2 + 3, 1.5 + 4, 1}),
              EigenNear(Vector3d(2, 1.5, 0), 1e-12));  // along the edge's normal
  EXPECT_THAT(nearest({1, 1, 7}), EigenNear(Vector3d(1, 1, 0), 1e-12));
}

TEST(NearestOnTriangle, IsNoFartherThanAnyPointOfAGridOnIt) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-5, 5);
  const auto any = [&] { return Vector3d(at(random), at(random), at(random)); };
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3d a = any(), b = any(), c = any(), p = any();
    const auto nearest = nearestOnTriangle(p, a, b, c);
    double least = 1e9;
    constexpr int kSteps = 60;
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; i + j <= kSteps; ++j)
        least = std::min(least, (a + (b - a) * i / kSteps + (c - a) * j / kSteps - p).norm());
    EXPECT_LE((nearest.point - p).norm(), least + 1e-9);
    EXPECT_THAT(Vector3d(nearest.weights[0] * a + nearest.weights[1] * b + nearest.weights[2] * c),
                EigenNear(nearest.point, 1e-9));
    EXPECT_GE(nearest.weights.minCoeff(), -1e-12);
    EXPECT_NEAR(nearest.weights.sum(), 1, 1e-12);
  }
}

TEST(NearestOnTriangle, OfATriangleWithoutAreaLiesOnIt) {
  const Vector3d end(2, 2, 0);
  const Vector3d p = nearestOnTriangle(Vector3d(1, 1, 4), kA, kA, end).point;
  EXPECT_THAT(p, EigenNear(Vector3d(1, 1, 0), 1e-12));
  EXPECT_THAT(nearestOnTriangle(Vector3d(1, 2, 3), kB, kB, kB).point, EigenNear(kB, 1e-12));
}

}  // namespace
}  // namespace facenav
