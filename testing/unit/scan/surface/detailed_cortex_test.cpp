#include "facenav/surface/detailed_cortex.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "facenav/core/error.h"
#include "facenav/surface/closest_point.h"
#include "support/test_data.h"

// A ball of 40 mm with a ring-shaped sulcus of known depth, and grey values that encode the depth.

namespace facenav {
namespace {

using Eigen::Vector3d;
using surface::TriangleMesh;

constexpr double kRadius_mm = 40, kSulcus_mm = 12, kHalfWidth_mm = 2;

volume::VoxelGrid grid() {
  volume::VoxelGrid grid;
  grid.size = {96, 96, 96};
  grid.mri_from_voxel.translation() = Vector3d::Constant(-47.5);
  return grid;
}

/// A volume with `value` of each voxel's position.
template <class Value>
volume::Volume made(Value&& value) {
  volume::Volume out{grid(), {}, {}, {}};
  for (int k = 0; k < 96; ++k)
    for (int j = 0; j < 96; ++j)
      for (int i = 0; i < 96; ++i) out.voxels.push_back(float(value(grid().toMri(Vector3d(i, j, k)).mm)));
  return out;
}

/// 1 in the ball except for a cut around its equator; slopes of one voxel at the edges.
volume::Volume tissue() {
  return made([](const Vector3d& p) {
    const double to_surface = kRadius_mm - p.norm();
    const double to_sulcus = std::max(std::abs(p.z()) - kHalfWidth_mm, to_surface - kSulcus_mm);
    return std::clamp(std::min(to_surface, to_sulcus) + 0.5, 0.0, 1.0);
  });
}

volume::Mask ball() {
  volume::Mask mask{grid(), {}};
  for (const float v : made([](const Vector3d& p) { return p.norm() < kRadius_mm; }).voxels)
    mask.voxels.push_back(v > 0);
  return mask;
}

surface::BrainModel model() {
  TaskMonitor monitor;
  return surface::buildBrainModel(made([](const Vector3d&) { return 1; }), ball(), {}, monitor);
}

surface::DetailedCortex cortex(const surface::BrainModel& to) {
  TaskMonitor monitor;
  surface::DetailedCortex cortex{surface::extractCortex(tissue(), 10, monitor), {}};
  cortex.distance_mm = surface::signedDistances_mm(cortex.mesh, to.mesh);
  return cortex;
}

TEST(DetailedCortex, HasBothBanksOfASulcusAndItsFloor) {
  const auto found = cortex(model());
  int upper = 0, lower = 0, floor = 0;
  for (std::size_t v = 0; v < found.mesh.vertices_mm.size(); ++v) {
    const Vector3d p = found.mesh.vertices_mm[v];
    const double depth = kRadius_mm - p.norm();
    if (depth < 4) continue;
    ASSERT_LT(depth, kSulcus_mm + 0.7);
    if (depth > kSulcus_mm - 1.5) {
      ++floor;
      continue;
    }
    const double bank = p.z() > 0 ? 1 : -1;
    ++(bank > 0 ? upper : lower);
    ASSERT_NEAR(p.z(), bank * kHalfWidth_mm, 0.6);
    ASSERT_GT(-bank * found.mesh.normals[v].z(), 0.7);
  }
  EXPECT_GT(upper, 500);
  EXPECT_GT(lower, 500);
  EXPECT_GT(floor, 100);
}

TEST(DetailedCortex, LeavesNothingOfTheSmallPartsThatItDrops) {
  auto with_crumb = tissue();
  for (int k = 2; k < 6; ++k)
    for (int j = 2; j < 6; ++j)
      for (int i = 2; i < 6; ++i) with_crumb.voxels[with_crumb.grid.index(i, j, k)] = 1;
  TaskMonitor monitor;
  for (const int smoothing_steps : {0, 10}) {
    const auto mesh = surface::extractCortex(with_crumb, smoothing_steps, monitor);
    std::vector<bool> is_used(mesh.vertices_mm.size());
    for (const auto& t : mesh.triangles)
      for (int c = 0; c < 3; ++c) is_used[std::size_t(t[c])] = true;
    for (std::size_t v = 0; v < is_used.size(); ++v) {
      ASSERT_TRUE(is_used[v]);
      ASSERT_LT(mesh.vertices_mm[v].norm(), kRadius_mm + 1);
    }
  }
}

TEST(DetailedCortex, LiesAsFarBelowTheModelAsTheSulcusIsDeepWhileTheModelLiesCloseToIt) {
  const auto to = model();
  const auto found = cortex(to);
  for (std::size_t v = 0; v < found.distance_mm.size(); ++v)
    ASSERT_NEAR(found.distance_mm[v], found.mesh.vertices_mm[v].norm() - kRadius_mm, 0.6);
  const auto both = surface::distanceBetween(found, to);
  EXPECT_NEAR(both.cortex_to_model.max_mm, kSulcus_mm, 0.7);
  EXPECT_LT(both.model_to_cortex.max_mm, kHalfWidth_mm + 0.7);
  EXPECT_LT(both.model_to_cortex.median_mm, 0.3);
}

TEST(DetailedCortex, IsReadBackAsItWasWritten) {
  const testing::TemporaryFolder folder;
  const auto written = cortex(model());
  surface::writeCortex(written, folder.path() / "cortex.vtp");
  const auto read = surface::readCortex(folder.path() / "cortex.vtp");
  EXPECT_EQ(read.distance_mm, written.distance_mm);
  ASSERT_EQ(read.mesh.vertices_mm.size(), written.mesh.vertices_mm.size());
  EXPECT_LT((read.mesh.vertices_mm[77] - written.mesh.vertices_mm[77]).norm(), 1e-3);
  EXPECT_EQ(read.mesh.triangles.size(), written.mesh.triangles.size());
  EXPECT_THROW(surface::readCortex(folder.path() / "none.vtp"), Error);
}

TEST(PeelTexture, ShowsTheValueOfTheAskedDepthBelowTheHull) {
  const auto mri =
      made([](const Vector3d& p) { return p.norm() < kRadius_mm ? 100 + kRadius_mm - p.norm() : 0; });
  const auto mesh = model().mesh;
  const surface::PeelTexture peel(mri, ball(), mesh);
  double previous = -1;
  for (const double depth_mm : {2.0, 6.0, 12.0, 20.0}) {
    const auto grey = peel.greyAt(depth_mm);
    ASSERT_EQ(grey.size(), mesh.vertices_mm.size());
    const auto [low, high] = std::minmax_element(grey.begin(), grey.end());
    EXPECT_LE(*high - *low, 20) << depth_mm;  // of 255 over some 35 mm: 3 mm
    EXPECT_GT(*low, previous);
    previous = *high;
  }
}

TEST(ClosestPoint, AgreesWithTryingEveryTriangle) {
  const TriangleMesh mesh = model().mesh;
  TriangleMesh few = mesh;
  few.triangles.resize(300);
  const surface::ClosestPoint tree(few);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-80, 80);
  std::optional<int> near;
  for (int n = 0; n < 300; ++n) {
    const Vector3d p(place(random), place(random), place(random));
    double least = 1e9;  // over a fine sampling of every triangle
    for (const auto& t : few.triangles)
      for (int u = 0; u <= 12; ++u)
        for (int v = 0; u + v <= 12; ++v)
          least = std::min(least, (p - (u * few.vertices_mm[t[0]] + v * few.vertices_mm[t[1]] +
                                        (12 - u - v) * few.vertices_mm[t[2]]) /
                                           12)
                                      .norm());
    const auto found = tree.nearest(Point<Mri>(p)), hinted = tree.nearest(Point<Mri>(p), near);
    ASSERT_LE(found.distance_mm, least + 1e-3);
    ASSERT_GT(found.distance_mm, least - 0.05);
    ASSERT_NEAR(found.distance_mm, hinted.distance_mm, 1e-3);
    near = found.triangle;
  }
}

}  // namespace
}  // namespace facenav
