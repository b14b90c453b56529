#include "facenav/surface/cortex_surface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "facenav/core/error.h"
#include "facenav/surface/closest_point.h"
#include "facenav/surface/surface_distance.h"
#include "support/matchers.h"

namespace facenav {
namespace {

using Eigen::Vector3d;

volume::Mask ball(double radius_mm) {
  volume::Mask mask;
  mask.grid.size = {70, 60, 80};
  mask.grid.mri_from_voxel = Eigen::AngleAxisd(0.4, Vector3d(1, -1, 2).normalized()) *
                             Eigen::Scaling(Vector3d(1.2, 1.4, 1.1)) *
                             Eigen::Translation3d(-34.5, -29.5, -39.5);
  for (int k = 0; k < 80; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 70; ++i)
        mask.voxels.push_back(mask.grid.toMri({double(i), double(j), double(k)}).mm.norm() <= radius_mm);
  return mask;
}

TEST(SurfaceDistance, OfTwoBallsIsTheDifferenceOfTheirRadii) {
  TaskMonitor monitor;
  const auto small = surface::extractCortex(ball(25), {}, monitor),
             large = surface::extractCortex(ball(30), {}, monitor);
  const auto inwards = surface::signedDistances_mm(small, large),
             outwards = surface::signedDistances_mm(large, small, 7);
  EXPECT_EQ(inwards.size(), small.vertices_mm.size());
  EXPECT_EQ(outwards.size(), (large.vertices_mm.size() + 6) / 7);
  for (float d : inwards) ASSERT_NEAR(d, -5, 1.2);
  for (float d : outwards) ASSERT_NEAR(d, 5, 1.2);
  const auto figures = surface::summarise(inwards);
  EXPECT_NEAR(figures.median_mm, 5, 0.3);
  EXPECT_GE(figures.p95_mm, figures.median_mm);
  EXPECT_EQ(surface::summarise({}).max_mm, 0);
}

TEST(SurfaceDistance, StatesTheQuantilesOfTheSizes) {
  std::vector<float> distances;
  for (int n = 0; n <= 100; ++n) distances.push_back(float(n % 2 ? n : -n));
  const auto figures = surface::summarise(distances);
  EXPECT_EQ(figures.median_mm, 50);
  EXPECT_EQ(figures.p95_mm, 95);
  EXPECT_EQ(figures.max_mm, 100);
}

TEST(CortexSurface, LiesOnTheBallAndPointsOutwards) {
  TaskMonitor monitor;
  const auto mesh = surface::extractCortex(ball(30), {}, monitor);
  double sum = 0, volume_mm3 = 0;
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i) {
    const double r = mesh.vertices_mm[i].norm();
    sum += r;
    ASSERT_NEAR(r, 30, 0.8);
    ASSERT_GT(mesh.normals[i].dot(mesh.vertices_mm[i] / r), 0.8);
  }
  for (const auto& t : mesh.triangles)
    volume_mm3 += mesh.vertices_mm[t[0]].dot(mesh.vertices_mm[t[1]].cross(mesh.vertices_mm[t[2]])) / 6;
  EXPECT_NEAR(sum / double(mesh.vertices_mm.size()), 30, 0.15);
  EXPECT_NEAR(volume_mm3 / (4 * M_PI / 3 * 27000), 1, 0.02);
}

TEST(ClosestPoint, FindsTheCortexUnderAPointOfTheScalp) {
  TaskMonitor monitor;
  const surface::ClosestPoint cortex(surface::extractCortex(ball(30), {}, monitor));
  const Vector3d direction = Vector3d(1, 2, -1).normalized();
  const auto under = cortex.nearest(Point<Mri>(45 * direction));
  EXPECT_NEAR(under.distance_mm, 15, 0.5);
  EXPECT_TRUE(under.is_outside);
  EXPECT_THAT(under.point.mm, testing::EigenNear(Vector3d(30 * direction), 2.0));
  EXPECT_GT(under.normal.v.dot(direction), 0.9);
  EXPECT_FALSE(cortex.nearest(Point<Mri>(20 * direction)).is_outside);
}

TEST(ClosestPoint, RefusesAnEmptyMesh) {
  EXPECT_THROW(surface::ClosestPoint(surface::TriangleMesh()), Error);
}

}  // namespace
}  // namespace facenav
