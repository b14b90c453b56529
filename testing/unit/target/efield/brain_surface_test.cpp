// The brain's surface within the fluid: balls with known radii and sulci of known width, and random masks.

#include "facenav/efield/brain_surface.h"

#include <gtest/gtest.h>

#include <map>

#include "efield_scene.h"
#include "facenav/volume/mask_morphology.h"
#include "model/cell_surface.h"
#include "model/radial_shell.h"
#include "model/shell_surface.h"
#include "model/solid_mask.h"
#include "support/refusal.h"

namespace facenav::efield::testing {
namespace {

using facenav::testing::refusalOf;

volume::Volume shareOf(const volume::Mask& mask) {
  volume::Volume share;
  share.grid = mask.grid;
  share.voxels.assign(mask.voxels.begin(), mask.voxels.end());
  return share;
}

/// A ball whose top is cut by a slit along x, `half_width_mm` to both sides and down to z = 45 mm.
surface::TriangleMesh ballWithSlit(double radius_mm, double half_width_mm) {
  volume::Mask mask;
  mask.grid.size = {190, 190, 190};
  mask.grid.mri_from_voxel.translation().setConstant(-94.5);
  for (int k = 0; k < 190; ++k)
    for (int j = 0; j < 190; ++j)
      for (int i = 0; i < 190; ++i) {
        const Vector3d p = mask.grid.toMri(Vector3d(i, j, k)).mm;
        mask.voxels.push_back(p.norm() < radius_mm && !(std::abs(p.y()) < half_width_mm && p.z() > 45));
      }
  const volume::Volume share = shareOf(mask);
  return triangleMesh(cellSurface(mask, share));
}

/// Number of triangles with each directed edge; a manifold has each edge once in both directions.
int worstEdge(const ShellMesh& mesh) {
  std::map<std::pair<int, int>, int> counts;
  int worst = 0;
  for (const auto t : mesh.triangles.colwise())
    for (int c = 0; c < 3; ++c) worst = std::max(worst, ++counts[{t[c], t[(c + 1) % 3]}]);
  for (const auto& [edge, count] : counts)
    if (counts.count({edge.second, edge.first}) == 0) return -1;
  return worst;
}

TEST(SolidMask, OfABallHasItsVolume) {
  const surface::TriangleMesh mesh = triangleMesh(ball(40, 4));
  const volume::Mask solid = solidMask(mesh, gridAround(mesh, 1.0, 3.0));
  EXPECT_NEAR(solid.volume_ml(), 1e-3 * volumeWithin_mm3(ball(40, 4)), 0.3);
  EXPECT_NEAR(volume::largestPart(solid).volume_ml(), solid.volume_ml(), 1e-9) << "no stray lines";
}

TEST(CellSurface, OfAnyMaskIsAManifold) {
  std::mt19937 random(4);
  volume::Mask mask;
  mask.grid.size = {14, 14, 14};
  mask.voxels.assign(mask.grid.count(), 0);
  for (int k = 1; k < 13; ++k)
    for (int j = 1; j < 13; ++j)
      for (int i = 1; i < 13; ++i) mask.voxels[mask.grid.index(i, j, k)] = random() % 3 == 0;
  const volume::Volume share = shareOf(mask);
  EXPECT_NE(worstEdge(cellSurface(mask, share)), 1) << "diagonal neighbours share an edge";
  joinDiagonals(mask, share);
  EXPECT_EQ(worstEdge(cellSurface(mask, share)), 1);
  EXPECT_GT(volumeWithin_mm3(cellSurface(mask, share)), 0);
}

TEST(BrainSurface, OfABallHasItsRadiusAndRoomForTheFluid) {
  const ShellMesh inner_skull = ball(75, 3);
  const ShellMesh brain = brainSurface(ballWithSlit(71, 0), inner_skull, {3000, 4.0});
  requireClosed(brain, "brain");
  EXPECT_LE(brain.vertices_mm.cols(), 3000);
  const Eigen::VectorXd radii = brain.vertices_mm.colwise().norm();
  EXPECT_NEAR(radii.mean(), 71, 0.5);
  EXPECT_LT((radii.array() - radii.mean()).abs().maxCoeff(), 1.0);
  EXPECT_GT(gaps_mm(brain, inner_skull).minCoeff(), 1.0);
  // A brain that touches the skull is cut back.
  const ShellMesh tight = brainSurface(ballWithSlit(75, 0), inner_skull, {3000, 4.0});
  EXPECT_GT(gaps_mm(tight, inner_skull).minCoeff(), 1.0);
}

TEST(BrainSurface, FollowsAWideSulcusAndClosesANarrowOne) {
  const ShellMesh inner_skull = ball(75, 3);
  const auto lowestOnTop = [&](double half_width_mm) {
    const ShellMesh brain = brainSurface(ballWithSlit(71, half_width_mm), inner_skull, {6000, 3.0});
    double lowest_mm = 1e9;
    for (const auto v : brain.vertices_mm.colwise())
      if (v.head<2>().norm() < 15 && v.z() > 0) lowest_mm = std::min(lowest_mm, v.z());
    return lowest_mm;
  };
  EXPECT_NEAR(lowestOnTop(4), 45, 2);
  EXPECT_GT(lowestOnTop(0.5), 67) << "1 mm is less than the mesh can follow";
}

TEST(BrainSurface, SaysWhenThereIsNoBrainInTheSkull) {
  surface::TriangleMesh away = triangleMesh(ball(20, 3));
  for (auto& vertex : away.vertices_mm) vertex.x() += 300;
  EXPECT_NE(refusalOf([&] { brainSurface(away, ball(75, 3)); }).find("outside the brain mask"),
            std::string::npos);
}

}  // namespace
}  // namespace facenav::efield::testing
