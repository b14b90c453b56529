#include "facenav/surface/scalp_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "facenav/core/error.h"
#include "support/matchers.h"

namespace facenav::surface {
namespace {
using facenav::testing::EigenNear;

constexpr double kPathBall_mm = 90;

/// Body given by its radius in each direction, with vertices about `step_mm` apart at 90 mm.
template <class Radius>
TriangleMesh pathBody(double step_mm, Radius radius) {
  TriangleMesh mesh;
  const int rows = int(M_PI * kPathBall_mm / step_mm), columns = 2 * rows;
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const double phi = M_PI * i / rows, theta = 2 * M_PI * j / columns;
      const Eigen::Vector3d n(std::sin(phi) * std::cos(theta), std::sin(phi) * std::sin(theta),
                              std::cos(phi));
      mesh.vertices_mm.push_back(radius(n) * n);
      mesh.normals.push_back(n);
    }
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const int a = i * columns + j, b = i * columns + (j + 1) % columns;
      if (i > 0) mesh.triangles.emplace_back(a, a + columns, b);
      if (i + 1 < rows) mesh.triangles.emplace_back(b, a + columns, b + columns);
    }
  return mesh;
}
TriangleMesh pathBall(double step_mm) {
  return pathBody(step_mm, [](const Eigen::Vector3d&) { return kPathBall_mm; });
}

Eigen::Vector3d direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

TEST(ScalpPath, OnABallIsTheGreatCircleWithinHalfAPercent) {
  for (const double step_mm : {1.5, 3.0}) {
    const ScalpPaths paths(pathBall(step_mm));
    std::mt19937 random(7);
    double worst = 0;
    for (int trial = 0; trial < 25; ++trial) {
      const Eigen::Vector3d a = direction(random), b = direction(random);
      const double angle = std::acos(std::clamp(a.dot(b), -1.0, 1.0));
      if (angle < 0.1 || angle > 2.8) continue;
      const double length_mm = paths.shortest(kPathBall_mm * a, kPathBall_mm * b).length_mm();
      worst = std::max(worst, std::abs(length_mm / (kPathBall_mm * angle) - 1));
    }
    EXPECT_LT(worst, 0.005) << "vertices " << step_mm << " mm apart";
    RecordProperty("worst_per_mille", int(std::lround(1000 * worst)));
  }
}

TEST(ScalpPath, RoughSkinOfAScanHardlyLengthensIt) {
  std::mt19937 random(3);
  std::normal_distribution<double> rough(0, 0.15);
  const ScalpPaths paths(pathBody(1.5, [&](const Eigen::Vector3d&) { return kPathBall_mm + rough(random); }));
  const Eigen::Vector3d a = Eigen::Vector3d(1, 0.2, 0.3).normalized(),
                        b = Eigen::Vector3d(-0.2, 1, 0.4).normalized();
  const double expected_mm = kPathBall_mm * std::acos(a.dot(b));
  EXPECT_NEAR(paths.shortest(kPathBall_mm * a, kPathBall_mm * b).length_mm() / expected_mm, 1.0, 0.01);
}

TEST(ScalpPath, GoesRoundAHillWhereThatIsShorter) {
  // A hill of 25 mm between the two places: the way over it is longer than around it.
  const auto hilly = pathBody(1.5, [](const Eigen::Vector3d& n) {
    const double away_mm = kPathBall_mm * (n - Eigen::Vector3d::UnitZ()).norm();
    return kPathBall_mm + 25 * std::exp(-0.5 * away_mm * away_mm / 64);
  });
  const ScalpPaths paths(hilly);
  const Eigen::Vector3d a = kPathBall_mm * Eigen::Vector3d(std::sin(0.4), 0.01, std::cos(0.4)),
                        b = kPathBall_mm * Eigen::Vector3d(-std::sin(0.4), 0.01, std::cos(0.4));
  const ScalpPath way = paths.shortest(a, b);
  const double over_mm = 2 * std::hypot(25, 0.4 * kPathBall_mm);
  EXPECT_LT(way.length_mm(), over_mm);
  EXPECT_GT(way.length_mm(), 0.8 * kPathBall_mm - 0.2) << "and not through it";
  EXPECT_GT(std::abs(way.atFraction(0.5).y()), 8.0);
}

TEST(ScalpPath, HasPlacesAndDirectionsAlongIt) {
  const ScalpPath path({{0, 0, 0}, {3, 0, 0}, {3, 4, 0}});
  EXPECT_NEAR(path.length_mm(), 7, 1e-12);
  EXPECT_THAT(path.at(5), EigenNear(Eigen::Vector3d(3, 2, 0), 1e-12));
  EXPECT_THAT(path.at(-1), EigenNear(Eigen::Vector3d(0, 0, 0), 1e-12));
  EXPECT_THAT(path.at(99), EigenNear(Eigen::Vector3d(3, 4, 0), 1e-12));
  EXPECT_THAT(path.direction(5), EigenNear(Eigen::Vector3d(0, 1, 0), 1e-12));
}

TEST(ScalpTape, IsTheArcOfACircleOnABall) {
  const ScalpPaths paths(pathBall(1.5));
  const ScalpPath tape = paths.tape({90, 0, 0}, {0, 0, 90}, {-90, 0, 0});
  EXPECT_NEAR(tape.length_mm(), M_PI * 90, 0.1);
  EXPECT_THAT(tape.atFraction(0.5), EigenNear(Eigen::Vector3d(0, 0, 90), 0.1));
  EXPECT_THAT(tape.atFraction(0.25), EigenNear(90 * Eigen::Vector3d(1, 0, 1).normalized(), 0.1));
}

TEST(ScalpTape, SpansAHollowInTheAir) {
  // A dent of 6 mm at the top: the tape goes straight over it, skin would be longer.
  const auto dented = pathBody(1.0, [](const Eigen::Vector3d& n) {
    const double away_mm = kPathBall_mm * (n - Eigen::Vector3d::UnitZ()).norm();
    return kPathBall_mm - 6 * std::exp(-0.5 * away_mm * away_mm / 64);
  });
  const ScalpPaths paths(dented);
  const ScalpPath tape = paths.tape({90, 0, 0}, {0, 0, 84}, {-90, 0, 0});
  EXPECT_GT(tape.atFraction(0.5).z(), 86.5) << "in the air over the dent";
  EXPECT_LT(tape.length_mm(), M_PI * 90);
  EXPECT_GT(tape.length_mm(), M_PI * 90 - 1.5);
}

TEST(ScalpTape, GoesOverSkinThatOverhangsItsEnds) {
  // The path starts below a brow, which protrudes in front of the start.
  const auto browed = pathBody(1.0, [](const Eigen::Vector3d& n) {
    const double away_mm = kPathBall_mm * (n - Eigen::Vector3d(std::cos(0.2), 0, std::sin(0.2))).norm();
    return kPathBall_mm + 10 * std::exp(-0.5 * away_mm * away_mm / 64);
  });
  const ScalpPath tape = ScalpPaths(browed).tape({90, 0, 0}, {0, 0, 90}, {-90, 0, 0});
  double furthest_mm = 0;
  for (const auto& p : tape.points_mm()) furthest_mm = std::max(furthest_mm, p.norm());
  EXPECT_NEAR(furthest_mm, 100, 0.3);
  EXPECT_THAT(tape.points_mm().front(), EigenNear(Eigen::Vector3d(90, 0, 0), 1e-9));
}

TEST(ScalpTape, RefusesPlacesOnOneLineAndPlacesOffTheSkin) {
  const ScalpPaths paths(pathBall(3));
  EXPECT_THROW(paths.tape({0, 0, 0}, {0, 0, 10}, {0, 0, 90}), Error);
  EXPECT_THROW(paths.tape({300, 0, 0}, {300, 0, 10}, {300, 10, 0}), Error);
}

TEST(ScalpPath, RefusesAWayOverAGapInTheSkin) {
  TriangleMesh two = pathBall(6);
  const TriangleMesh other = two;
  const int offset = int(two.vertices_mm.size());
  for (const auto& v : other.vertices_mm) two.vertices_mm.push_back(v + Eigen::Vector3d(300, 0, 0));
  for (const auto& t : other.triangles) two.triangles.push_back(t + Eigen::Vector3i::Constant(offset));
  EXPECT_THROW(ScalpPaths(two).shortest({0, 0, 90}, {300, 0, 90}), Error);
}

}  // namespace
}  // namespace facenav::surface
