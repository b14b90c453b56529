#include "facenav/guidance/target_grid.h"

#include <gtest/gtest.h>

#include "facenav/core/error.h"
#include "made_targets.h"
#include "support/matchers.h"

namespace facenav::guidance {
namespace {
using namespace guidance::testing;
using facenav::testing::EigenNear;

constexpr double kGridBall_mm = 90;

const surface::TriangleMesh& gridBall() {
  static const surface::TriangleMesh kBall = sphere(Eigen::Vector3d::Zero(), kGridBall_mm, 180);
  return kBall;
}
const surface::ScalpPaths& gridPaths() {
  static const surface::ScalpPaths kPaths(gridBall());
  return kPaths;
}

/// Axes of a coil over `direction`, its handle straight back.
Eigen::Matrix3d axesOver(const Eigen::Vector3d& direction) {
  return poseFrom<frames::Target>(Eigen::Vector3d::Zero(), -direction, Eigen::Vector3d::UnitY()).rotation();
}

std::vector<GridPoint> gridOver(const Eigen::Vector3d& direction, const GridSpec& spec) {
  return gridRound(gridPaths(), gridBall(), kGridBall_mm * direction.normalized(), axesOver(direction), spec);
}

const GridPoint& gridAt(const std::vector<GridPoint>& points, int row, int column) {
  for (const GridPoint& p : points)
    if (p.row == row && p.column == column) return p;
  throw Error("no such place");
}

TEST(TargetGrid, IsCentredOnTheSeedWithRowOneInFrontAndColumnOneOnTheLeft) {
  const Eigen::Vector3d top(0, 0, 1);
  const auto points = gridOver(top, {3, 5, 8, GridOn::scalp});
  ASSERT_EQ(points.size(), 15u);
  EXPECT_THAT(gridAt(points, 2, 3).place_mm, EigenNear(kGridBall_mm * top, 0.1));
  EXPECT_GT(gridAt(points, 1, 3).place_mm.y(), 7.5) << "row 1 in front";
  EXPECT_LT(gridAt(points, 2, 1).place_mm.x(), -15) << "column 1 on the left, seen from above";
}

TEST(TargetGrid, SpacingAlongTheTapesIsAsAsked) {
  for (const Eigen::Vector3d& place : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(-1, 0.2, 1)}) {
    const auto points = gridOver(place, {5, 5, 10, GridOn::scalp});
    for (int row = 1; row <= 5; ++row)
      for (int column = 1; column < 5; ++column) {
        const double along_mm =
            gridPaths()
                .shortest(gridAt(points, row, column).place_mm, gridAt(points, row, column + 1).place_mm)
                .length_mm();
        EXPECT_NEAR(along_mm, 10.0, 0.1) << row << ' ' << column;
      }
    for (int row = 1; row < 5; ++row) {  // down the middle column
      const double along_mm =
          gridPaths()
              .shortest(gridAt(points, row, 3).place_mm, gridAt(points, row + 1, 3).place_mm)
              .length_mm();
      EXPECT_NEAR(along_mm, 10.0, 0.1) << row;
    }
  }
}

TEST(TargetGrid, OuterColumnsCloseInAsTheCurvatureSays) {
  const auto points = gridOver({0, 0, 1}, {3, 5, 10, GridOn::scalp});
  const double along_mm =
      gridPaths().shortest(gridAt(points, 1, 1).place_mm, gridAt(points, 2, 1).place_mm).length_mm();
  // 20 mm beside the middle column on a ball of 90 mm.
  EXPECT_NEAR(along_mm, 10.0 * std::cos(20.0 / 90), 0.12);
}

TEST(TargetGrid, CarriesTheHandleParallelAlongTheTapes) {
  // On a ball, the direction carried along the great circle to the left keeps its angle to it: it stays
  // perpendicular to the tape, so that it lies in the planes through the seed's forward axis.
  const auto points = gridOver({0, 0, 1}, {1, 5, 15, GridOn::scalp});
  for (const GridPoint& p : points) {
    EXPECT_THAT(p.outwards, EigenNear(p.place_mm.normalized(), 0.01));
    EXPECT_THAT(p.forward, EigenNear(Eigen::Vector3d(0, 1, 0), 0.01)) << p.column;
  }
}

TEST(TargetGrid, AnEvenNumberLeavesTheSeedBetweenItsPlaces) {
  const auto points = gridOver({0, 0, 1}, {2, 2, 10, GridOn::scalp});
  ASSERT_EQ(points.size(), 4u);
  EXPECT_NEAR(gridAt(points, 1, 1).place_mm.y(), 5.0, 0.1);
  EXPECT_NEAR(gridAt(points, 2, 2).place_mm.x(), 5.0, 0.1);
}

TEST(TargetGrid, RefusesSizesThatMakeNoGrid) {
  EXPECT_THROW(requireSensible({1, 1, 10, GridOn::scalp}), Error);
  EXPECT_THROW(requireSensible({16, 2, 10, GridOn::scalp}), Error);
  EXPECT_THROW(requireSensible({3, 3, 0.5, GridOn::scalp}), Error);
  EXPECT_THROW(requireSensible({3, 3, 31, GridOn::scalp}), Error);
}

}  // namespace
}  // namespace facenav::guidance
