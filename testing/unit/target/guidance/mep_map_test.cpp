#include "facenav/guidance/mep_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace facenav::guidance {
namespace {

/// Square of 80 mm in the plane z = 0 with a vertex every millimetre, seen from above (outward +z).
surface::TriangleMesh plane() {
  surface::TriangleMesh mesh;
  constexpr int kSide = 81;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      mesh.vertices_mm.emplace_back(x - 40, y - 40, 0);
      mesh.normals.emplace_back(0, 0, 1);
    }
  for (int y = 0; y + 1 < kSide; ++y)
    for (int x = 0; x + 1 < kSide; ++x) {
      const int i = y * kSide + x;
      mesh.triangles.emplace_back(i, i + 1, i + kSide);
      mesh.triangles.emplace_back(i + 1, i + kSide + 1, i + kSide);
    }
  return mesh;
}

float valueAt(const surface::TriangleMesh& mesh, const MepMap& map, double x, double y) {
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i)
    if ((mesh.vertices_mm[i] - Eigen::Vector3d(x, y, 0)).norm() < 1e-9) return map.mep_uv[i];
  return -1;
}

TEST(MepMap, OneSiteGivesADiscOfItsOwnValue) {
  const auto mesh = plane();
  const auto map = mepMap(mesh, {{{3, -4, 0}, 200}}, {});
  ASSERT_TRUE(map);
  EXPECT_FLOAT_EQ(valueAt(mesh, *map, 3, -4), 200);
  EXPECT_FLOAT_EQ(valueAt(mesh, *map, 12, -4), 200) << "a mean of one value is that value";
  EXPECT_TRUE(std::isnan(valueAt(mesh, *map, 14, -4))) << "11 mm away: nothing is known there";
  EXPECT_NEAR(map->area_mm2, M_PI * 100, 0.02 * M_PI * 100);
  EXPECT_NEAR((map->centre_of_gravity.mm - Eigen::Vector3d(3, -4, 0)).norm(), 0, 1e-12);
}

TEST(MepMap, TwoSitesMeetInTheMeanOfBothAndTheGaussianIsThatOfTheOption) {
  const auto mesh = plane();
  MepMapOptions options;
  options.mep_sigma_mm = 4;
  const auto map = mepMap(mesh, {{{-5, 0, 0}, 100}, {{5, 0, 0}, 300}}, options);
  ASSERT_TRUE(map);
  EXPECT_NEAR(valueAt(mesh, *map, 0, 0), 200, 1e-3);
  const double near = std::exp(-9.0 / 32.0), far = std::exp(-49.0 / 32.0);  // from (2, 0): 3 and 7 mm
  EXPECT_NEAR(valueAt(mesh, *map, 2, 0), (300 * near + 100 * far) / (near + far), 1e-3);
  EXPECT_NEAR(map->centre_of_gravity.mm.x(), (-5 * 100 + 5 * 300) / 400.0, 1e-12);
  EXPECT_NEAR((map->peak.mm - Eigen::Vector3d(9, 0, 0)).norm(), 0, 1e-9)
      << "away from the weaker site, but no further than sigma from a site";
  EXPECT_LT(map->peak_uv, 300) << "a mean never exceeds the largest MEP";
  EXPECT_EQ(map->largest_uv, 300);
}

TEST(MepMap, AreaCountsOnlyWhereTheMapReachesTheThreshold) {
  const auto mesh = plane();
  // 0 and 100 uV at equal weight: 50 uV is reached from the middle line on.
  const auto map = mepMap(mesh, {{{-5, 0, 0}, 0}, {{5, 0, 0}, 100}}, {});
  ASSERT_TRUE(map);
  EXPECT_EQ(map->sites, 2);
  EXPECT_EQ(map->responses, 1);
  // The part x >= 0 of the discs about both sites: the disc at (5, 0) but its segment beyond x = 0, and its
  // mirror image lies within it. Segment of a circle of 10 mm, 5 mm from its centre: r^2 (pi/3 - sqrt(3)/4).
  const double wanted_mm2 = 100 * (M_PI - (M_PI / 3 - std::sqrt(3.0) / 4));
  EXPECT_NEAR(map->area_mm2, wanted_mm2, 0.05 * wanted_mm2);
}

TEST(MepMap, WithoutAResponseThereIsNoMap) {
  EXPECT_FALSE(mepMap(plane(), {}, {}));
  EXPECT_FALSE(mepMap(plane(), {{{0, 0, 0}, 0}}, {}));
  EXPECT_FALSE(mepMap(plane(), {{{0, 0, 300}, 100}}, {})) << "far from the surface";
}

TEST(MepMap, TheCoilsAxisMeetsTheSurfaceBelowItAndNotBehindIt) {
  const auto mesh = plane();
  // 12 mm above the plane, axis tilted by 30 degrees about x: it meets the plane 12 tan 30 mm aside.
  const Eigen::Quaterniond down(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
  const Eigen::Quaterniond tilted = Eigen::AngleAxisd(M_PI / 6, Eigen::Vector3d::UnitX()) * down;
  const auto point = axisOnSurface(mesh, {tilted, {1, 2, 12}});
  ASSERT_TRUE(point);
  EXPECT_NEAR((point->mm - Eigen::Vector3d(1, 2 + 12 * std::tan(M_PI / 6), 0)).norm(), 0, 1e-9);
  EXPECT_FALSE(axisOnSurface(mesh, {Eigen::Quaterniond::Identity(), {1, 2, 12}})) << "it points away";
  EXPECT_FALSE(axisOnSurface(mesh, {down, {1, 200, 12}})) << "beside the surface";
}

}  // namespace
}  // namespace facenav::guidance
