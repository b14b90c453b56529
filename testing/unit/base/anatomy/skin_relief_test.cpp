#include "facenav/anatomy/skin_relief.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "facenav/anatomy/lateral_landmarks.h"

namespace facenav::anatomy {
namespace {

using Eigen::Vector3d;

/// Plane of 40 x 30 mm: height = 50 + 0.5 across + 0.25 up, as two triangles seen from `side`.
struct Plane {
  std::vector<Vector3d> head_mm;
  std::vector<Eigen::Vector3i> triangles{Eigen::Vector3i(0, 1, 2), Eigen::Vector3i(1, 3, 2)};
};
double planeAt(double across, double up) { return 50 + 0.5 * across + 0.25 * up; }
Plane planeSeenFrom(Side side) {
  Plane plane;
  for (const double up : {0.0, 30.0})
    for (const double across : {0.0, 40.0}) {
      const double height = planeAt(across, up);
      plane.head_mm.push_back(side == Side::front   ? Vector3d(across, height, up)
                              : side == Side::right ? Vector3d(height, across, up)
                                                    : Vector3d(-height, across, up));
    }
  return plane;
}

TEST(SkinRelief, IsThePlaneThatTheTrianglesSpanFromEachSide) {
  for (const Side side : {Side::front, Side::right, Side::left}) {
    const Plane plane = planeSeenFrom(side);
    const SkinRelief relief = reliefFrom(side, plane.head_mm, plane.triangles);
    for (const auto& [across, up] : {std::pair{0.0, 0.0}, {10.25, 7.5}, {39.5, 29.5}, {20.0, 15.75}}) {
      const auto height = relief.at(across, up);
      ASSERT_TRUE(height) << across << " " << up;
      EXPECT_NEAR(*height, planeAt(across, up), 1e-4);
    }
    EXPECT_FALSE(relief.at(-1.5, 10));
    EXPECT_FALSE(relief.at(20, 31.5));
  }
}

TEST(SkinRelief, KeepsTheHighestAndLeavesHolesOpen) {
  Plane plane = planeSeenFrom(Side::front);
  // A lower plane behind, and only one of its triangles before the hole.
  const std::size_t n = plane.head_mm.size();
  for (std::size_t i = 0; i < n; ++i) plane.head_mm.push_back(plane.head_mm[i] - Vector3d(0, 20, 0));
  plane.triangles = {Eigen::Vector3i(0, 1, 2), Eigen::Vector3i(4, 5, 6)};
  const SkinRelief relief = reliefFrom(Side::front, plane.head_mm, plane.triangles);
  EXPECT_NEAR(relief.cell(5, 5), planeAt(5, 5), 1e-4);
  EXPECT_EQ(relief.cell(38, 28), SkinRelief::kNone);
  EXPECT_EQ(relief.cell(-1, 0), SkinRelief::kNone);
}

SkinRelief reliefOf(int half_mm, const std::function<double(double, double)>& height) {
  SkinRelief relief;
  relief.left_mm = relief.bottom_mm = -half_mm;
  relief.columns = relief.rows = 2 * half_mm + 1;
  for (int up = -half_mm; up <= half_mm; ++up)
    for (int across = -half_mm; across <= half_mm; ++across)
      relief.height_mm.push_back(float(height(across, up)));
  return relief;
}

TEST(SkinRelief, SmoothingKeepsPlanesAndSpreadsASpikeAsAGaussian) {
  const SkinRelief plane = smoothed(reliefOf(20, planeAt), 1.5);
  EXPECT_NEAR(*plane.at(3.5, -7), planeAt(3.5, -7), 1e-3);
  const SkinRelief spike = smoothed(reliefOf(20, [](double a, double u) { return a == 0 && u == 0; }), 2.0);
  double sum = 0, squares = 0;
  for (int up = -20; up <= 20; ++up)
    for (int across = -20; across <= 20; ++across) {
      const double h = double(spike.cell(across + 20, up + 20));
      sum += h, squares += h * across * across;
    }
  EXPECT_NEAR(sum, 1.0, 1e-3);
  EXPECT_NEAR(std::sqrt(squares / sum), 2.0, 0.1);
}

TEST(SkinRelief, SmoothingDoesNotFillHolesOrDrawTheirRim) {
  SkinRelief relief = reliefOf(20, [](double, double) { return 80.0; });
  relief.height_mm[20 * 41 + 20] = SkinRelief::kNone;
  const SkinRelief smooth = smoothed(relief, 2.0);
  EXPECT_EQ(smooth.cell(20, 20), SkinRelief::kNone);
  EXPECT_NEAR(smooth.cell(21, 20), 80.0f, 1e-3f);
}

double bump(double d2, double width) { return std::exp(-0.5 * d2 / (width * width)); }
double square(double x) { return x * x; }

/// Face about the nasion at (0, 100, 0): a bridge, hollows at the eyes' inner corners, lids beside them.
SkinRelief eyes(double corner_mm, double corner_up_mm, double lid_mm) {
  return reliefOf(60, [=](double x, double z) {
    const double aside = std::abs(x);
    return 85 + 10 * bump(square(x), 6) -
           8 * bump(square(aside - corner_mm) + square(z - corner_up_mm), 3.5) +
           4 * bump(square(aside - lid_mm) + square(z - corner_up_mm), 6);
  });
}

TEST(Eye, CornerAndLidAreFoundOnBothSides) {
  const SkinRelief front = eyes(16, -8, 31);
  for (const int side : {1, -1}) {
    const EyeLandmarks eye = findEye(front, Vector3d(0, 95, 0), side);
    ASSERT_TRUE(eye.inner_corner);
    EXPECT_NEAR(eye.inner_corner->x(), side * 16, 1.5);
    EXPECT_NEAR(eye.inner_corner->z(), -8, 1.5);
    EXPECT_NEAR(eye.inner_corner->y(), *front.at(eye.inner_corner->x(), eye.inner_corner->z()), 1e-6);
    ASSERT_TRUE(eye.lid_centre);
    EXPECT_NEAR(eye.lid_centre->x(), side * 31, 2.0);
  }
}

TEST(Eye, AFlatFaceHasNone) {
  const SkinRelief flat = reliefOf(60, [](double x, double) { return 90 - 0.01 * x * x; });
  EXPECT_FALSE(findEye(flat, Vector3d(0, 90, 0), 1).inner_corner);
  EXPECT_FALSE(findEye(flat, Vector3d(0, 90, 0), 1).lid_centre);
}

TEST(Ala, IsTheOutermostSteepWall) {
  // Wings 17 mm from the midline at 6 to 10 mm above the base, 14 mm above and below.
  const SkinRelief front = reliefOf(60, [](double x, double z) {
    const double wall_mm = z >= 6 && z <= 10 ? 17 : 13;
    return 80 + 12 / (1 + std::exp((std::abs(x) - wall_mm) / 0.8));
  });
  for (const int side : {1, -1}) {
    const MaybePoint ala = findAla(front, Vector3d(0, 85, 0), side);
    ASSERT_TRUE(ala);
    EXPECT_NEAR(ala->x(), side * 17, 1.0);
    EXPECT_GE(ala->z(), 5);
    EXPECT_LE(ala->z(), 11);
  }
  const SkinRelief round = reliefOf(60, [](double x, double) { return 90 - 0.015 * x * x; });
  EXPECT_FALSE(findAla(round, Vector3d(0, 85, 0), 1)) << "a cheek is no wall";
}

TEST(Tragus, LiesBeforeTheEarsDeepestHollow) {
  // Seen from the side: across is y, up z. The hollow 95 mm behind the nasion, the tragus 8 mm before it.
  SkinRelief lateral = reliefOf(110, [](double y, double z) {
    return 70 - 9 * bump(square(y + 55) + square(z + 25), 4) + 3 * bump(square(y + 47) + square(z + 25), 3);
  });
  lateral.across_axis = 1;
  const Vector3d nasion(0, 40, 0);
  for (const int side : {1, -1}) {
    const MaybePoint tragus = findTragus(lateral, nasion, side);
    ASSERT_TRUE(tragus);
    EXPECT_NEAR(tragus->y(), -46.5, 2.0);
    EXPECT_NEAR(tragus->z(), -25, 2.0);
    EXPECT_EQ(tragus->x() > 0, side > 0);
    EXPECT_NEAR(std::abs(tragus->x()), 72, 1.0);
  }
  const SkinRelief shallow =
      reliefOf(110, [](double y, double z) { return 70 - 3 * bump(square(y + 55) + square(z + 25), 4); });
  EXPECT_FALSE(findTragus(shallow, nasion, 1)) << "a hollow of 3 mm is no ear";
}

}  // namespace
}  // namespace facenav::anatomy
