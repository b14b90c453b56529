#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "facenav/core/error.h"
#include "facenav/editing/lasso.h"
#include "facenav/editing/region_grow.h"
#include "facenav/editing/scalpel.h"
#include "facenav/editing/slice_interpolation.h"
#include "facenav/editing/whole_mask_tools.h"
#include "made_masks.h"

// Each tool is compared with brute force: the same rule applied to every voxel of the grid.

namespace facenav::editing {
namespace {

using testing::ballMask;
using testing::emptyMask;
using testing::obliqueGrid;
using testing::ramp;
using volume::Mask;

Point<Mri> at(const volume::VoxelGrid& grid, double i, double j, double k) { return grid.toMri({i, j, k}); }

Mask after(Mask mask, const MaskChange& change) {
  flip(mask, change);
  return mask;
}

void expectEachVoxelOnce(const MaskChange& change) {
  EXPECT_EQ(std::set<std::uint32_t>(change.voxels.begin(), change.voxels.end()).size(), change.size());
}

template <class Rule>
Mask byRule(const volume::VoxelGrid& grid, Rule&& rule) {
  Mask mask = emptyMask(grid);
  std::size_t v = 0;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i, ++v)
        mask.voxels[v] = rule(Eigen::Array3i(i, j, k), at(grid, i, j, k).mm);
  return mask;
}

TEST(Brush, ABallPaintsTheVoxelsWithinItsRadius) {
  const auto grid = obliqueGrid();
  const Mask empty = emptyMask(grid);
  const auto place = at(grid, 30.3, 25.1, 20.4);
  const auto change = paint(empty, {place, place}, {6.0, {}}, true);
  EXPECT_EQ(after(empty, change).voxels, ballMask(grid, place, 6.0).voxels);
  expectEachVoxelOnce(change);
  EXPECT_TRUE(paint(after(empty, change), {place, place}, {6.0, {}}, true).empty());  // already painted
}

TEST(Brush, AStrokeIsACapsuleAndTheEraserUndoesIt) {
  const auto grid = obliqueGrid();
  const Mask empty = emptyMask(grid);
  const BrushPath path{at(grid, 20, 25, 20), at(grid, 45, 30, 30)};
  const Eigen::Vector3d along = path.to.mm - path.from.mm;
  const Mask capsule = byRule(grid, [&](auto, const Eigen::Vector3d& p) {
    const double t = std::clamp((p - path.from.mm).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (p - path.from.mm - t * along).norm() <= 4;
  });
  const Mask painted = after(empty, paint(empty, path, {4.0, {}}, true));
  EXPECT_EQ(painted.voxels, capsule.voxels);
  EXPECT_EQ(after(painted, paint(painted, path, {4.0, {}}, false)).voxels, empty.voxels);
}

TEST(Brush, ADiscPaintsOneSlice) {
  const auto grid = obliqueGrid();
  const Direction<Mri> normal(Eigen::Vector3d(grid.mri_from_voxel.linear().col(2).normalized()));
  const auto place = at(grid, 30, 25, 20);
  const Mask empty = emptyMask(grid);
  const Mask painted = after(empty, paint(empty, {place, place}, {6.0, normal}, true));
  const Mask disc = byRule(grid, [&](const Eigen::Array3i& v, const Eigen::Vector3d& p) {
    return v[2] == 20 && (p - place.mm).norm() <= 6;
  });
  EXPECT_EQ(painted.voxels, disc.voxels);
}

TEST(Brush, ReachesOverTheEdgeOfTheScanWithoutHarm) {
  const auto grid = obliqueGrid();
  const Mask empty = emptyMask(grid);
  const auto corner = at(grid, 0, 0, 0), beyond = at(grid, -50, -50, -50);
  EXPECT_EQ(after(empty, paint(empty, {corner, corner}, {5.0, {}}, true)).voxels,
            ballMask(grid, corner, 5.0).voxels);
  EXPECT_TRUE(paint(empty, {beyond, beyond}, {5.0, {}}, true).empty());
}

TEST(Brush, OfAMillimetreScanTouchesOnlyWhatIsNear) {
  volume::VoxelGrid grid;
  grid.size = {256, 256, 256};
  const Mask empty = emptyMask(grid);
  const auto place = at(grid, 128, 128, 128);
  EXPECT_NEAR(double(paint(empty, {place, place}, {10.0, {}}, true).size()), 4.0 / 3 * M_PI * 1000, 80);
}

TEST(ThresholdPaint, KeepsToItsRange) {
  const auto grid = obliqueGrid();
  const auto volume = ramp(grid);
  const auto place = at(grid, 30, 25, 20);
  const Mask empty = emptyMask(grid);
  const Mask painted = after(empty, paintWithin(empty, volume, {28, 31}, {place, place}, {6.0, {}}, true));
  const Mask expected = byRule(grid, [&](const Eigen::Array3i& v, const Eigen::Vector3d& p) {
    return v[0] >= 28 && v[0] <= 31 && (p - place.mm).norm() <= 6;
  });
  EXPECT_EQ(painted.voxels, expected.voxels);
}

TEST(Lasso, FillsItsOutlineInTheSliceShownAlone) {
  volume::VoxelGrid grid;
  grid.size = {40, 40, 40};
  const auto plane = volume::anatomicalPlane(grid, volume::Anatomical::axial, Point<Mri>(20, 20, 17));
  Outline outline;  // an L in world x, y, drawn in the plane's pixels
  for (const auto& [x, y] :
       {std::pair{9.5, 9.5}, {30.5, 9.5}, {30.5, 15.5}, {15.5, 15.5}, {15.5, 30.5}, {9.5, 30.5}})
    outline.push_back(plane.toPixel(Point<Mri>(x, y, 17)).head<2>());
  const Mask empty = emptyMask(grid);
  const Mask painted = after(empty, lasso(empty, plane, outline, true));
  const Mask expected = byRule(grid, [](const Eigen::Array3i& v, auto) {
    const bool is_foot = v[0] >= 10 && v[0] <= 30 && v[1] >= 10 && v[1] <= 15;
    return v[2] == 17 && (is_foot || (v[0] >= 10 && v[0] <= 15 && v[1] >= 10 && v[1] <= 30));
  });
  EXPECT_EQ(painted.voxels, expected.voxels);
  EXPECT_EQ(after(painted, lasso(painted, plane, outline, false)).voxels, empty.voxels);
  EXPECT_TRUE(lasso(empty, plane, {outline[0], outline[1]}, true).empty());
}

TEST(RegionGrow, TakesTheConnectedPartAndStopsAtItsReach) {
  volume::VoxelGrid grid;
  grid.size = {40, 40, 40};
  volume::Volume volume{grid, std::vector<float>(grid.count(), 10.f), "MR", ""};
  const auto set = [&](int i, int j, int k) { volume.voxels[grid.index(i, j, k)] = 100; };
  for (int i = 2; i < 38; ++i) set(i, 20, 20);  // a thread, cut at 30
  volume.voxels[grid.index(30, 20, 20)] = 10;
  for (int k = 21; k < 25; ++k) set(10, 20, k);  // a branch
  const Mask empty = emptyMask(grid);
  const auto all = growRegion(empty, volume, Point<Mri>(10, 20, 20), {90, 110}, 100, true);
  EXPECT_EQ(all.size(), 28u + 4u);
  const auto near = growRegion(empty, volume, Point<Mri>(10, 20, 20), {90, 110}, 3, true);
  EXPECT_EQ(near.size(), 7u + 3u);
  EXPECT_TRUE(growRegion(empty, volume, Point<Mri>(10, 10, 10), {90, 110}, 100, true).empty());
  EXPECT_TRUE(growRegion(empty, volume, Point<Mri>(-10, 10, 10), {90, 110}, 100, true).empty());
  const Mask grown = after(empty, all);
  EXPECT_EQ(after(grown, growRegion(grown, volume, Point<Mri>(5, 20, 20), {90, 110}, 100, false)).voxels,
            empty.voxels);
}

TEST(RegionGrow, TakesItsRangeFromTheSurroundings) {
  const auto volume = ramp(obliqueGrid());
  const auto range = rangeAround(volume, at(volume.grid, 30, 20, 20), 2.0);  // values 29, 30, 31, nine each
  EXPECT_NEAR(range.low, 30 - 2 * std::sqrt(2.0 / 3), 1e-4);
  EXPECT_NEAR(range.high, 30 + 2 * std::sqrt(2.0 / 3), 1e-4);
  EXPECT_THROW(rangeAround(volume, at(volume.grid, -9, 0, 0)), Error);
}

TEST(Smooth, TakesASpikeAwayAndLeavesABallAsItIs) {
  volume::VoxelGrid grid;
  grid.size = {48, 48, 48};
  const Mask ball = ballMask(grid, Point<Mri>(24, 24, 24), 15);
  Mask spiked = ball;
  for (int i = 38; i < 46; ++i)
    spiked.voxels[grid.index(i, 24, 24)] = 1;  // a spike from the ball to the grid's edge
  const Mask smoothed = after(spiked, smooth(spiked, 1.0));
  EXPECT_FALSE(smoothed.at(43, 24, 24));
  EXPECT_GT(volume::overlap(smoothed, ball).dice, 0.985);
  const Ball elsewhere{Point<Mri>(10, 24, 24), 6};
  const auto local = smooth(spiked, 1.0, elsewhere);
  EXPECT_TRUE(after(spiked, local).at(43, 24, 24));  // outside the radius
  for (const auto v : local.voxels)
    EXPECT_LE((Eigen::Vector3d(v % 48, v / 48 % 48, v / 48 / 48) - elsewhere.centre.mm).norm(), 6);
}

TEST(FillHoles, FillsACavityAndLeavesAnOpenOne) {
  const auto grid = obliqueGrid();
  Mask ball = ballMask(grid, at(grid, 32, 30, 28), 15);
  const Mask whole = ball;
  ball.voxels[grid.index(32, 30, 28)] = 0;
  EXPECT_EQ(after(ball, fillHoles(ball)).voxels, whole.voxels);
  for (int i = 32; i < 64; ++i) ball.voxels[grid.index(i, 30, 28)] = 0;
  EXPECT_TRUE(fillHoles(ball).empty());
  EXPECT_TRUE(fillHoles(emptyMask(grid)).empty());
}

TEST(SliceInterpolation, MakesTheConeBetweenTwoDiscs) {
  volume::VoxelGrid grid;
  grid.size = {60, 60, 30};
  grid.mri_from_voxel.linear() = Eigen::Vector3d(1, 1, 2).asDiagonal();
  Mask drawn = byRule(grid, [](const Eigen::Array3i& v, auto) {
    const double radius = v[2] == 5 ? 8 : v[2] == 15 ? 20 : 0;
    return std::hypot(v[0] - 30, v[1] - 30) < radius;
  });
  const Mask made = after(drawn, interpolateSlices(drawn, 2, {15, 5}));
  for (int k = 5; k <= 15; ++k) {
    int count = 0;
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 60; ++i) count += made.at(i, j, k);
    EXPECT_NEAR(std::sqrt(count / M_PI), 8 + 1.2 * (k - 5), 0.6) << k;
  }
  EXPECT_FALSE(made.at(30, 30, 4));
  EXPECT_FALSE(made.at(30, 30, 16));
  EXPECT_TRUE(interpolateSlices(drawn, 2, {5, 20}).empty());  // slice 20 is empty
  EXPECT_THROW(interpolateSlices(drawn, 2, {5, 30}), Error);
}

TEST(SliceInterpolation, WorksAlongEachAxis) {
  volume::VoxelGrid grid;
  grid.size = {30, 32, 34};
  for (int axis = 0; axis < 3; ++axis) {
    const Mask drawn = byRule(grid, [&](const Eigen::Array3i& v, auto) {
      return (v[axis] == 10 || v[axis] == 20) && std::abs(v[(axis + 1) % 3] - 15) < 6 &&
             std::abs(v[(axis + 2) % 3] - 15) < 4;
    });
    const Mask made = after(drawn, interpolateSlices(drawn, axis, {10, 20}));
    const Mask block = byRule(grid, [&](const Eigen::Array3i& v, auto) {
      return v[axis] >= 10 && v[axis] <= 20 && std::abs(v[(axis + 1) % 3] - 15) < 6 &&
             std::abs(v[(axis + 2) % 3] - 15) < 4;
    });
    EXPECT_EQ(made.voxels, block.voxels) << axis;
  }
}

/// View from +x, at 300 mm; screen x = y of Mri, screen y = z, in mm at the centre's depth.
ScalpelView fromTheRight(const Eigen::Vector3d& centre) {
  ScalpelView view;
  view.eye = Point<Mri>(centre + Eigen::Vector3d(300, 0, 0));
  view.screen_from_mri << 0, 300, 0, -300 * centre.y(), 0, 0, 300, -300 * centre.z(), 0, 0, 0, 1, -1, 0, 0,
      view.eye.mm.x();
  return view;
}

TEST(Scalpel, CutsWhatLiesBehindTheOutlineThroughAndThrough) {
  const auto grid = obliqueGrid();
  const auto centre = at(grid, 32, 30, 28);
  const Mask ball = ballMask(grid, centre, 18);
  const auto view = fromTheRight(centre.mm);
  const Outline outline{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}};
  const auto change = cut(ball, view, outline);
  const Mask expected = byRule(grid, [&](auto, const Eigen::Vector3d& p) {
    const Eigen::Vector3d d = p - centre.mm;
    const double scale = 300 / (300 - d.x());
    return d.norm() <= 18 && !(std::abs(d.y()) * scale < 5 && std::abs(d.z()) * scale < 5);
  });
  EXPECT_EQ(after(ball, change).voxels, expected.voxels);
  expectEachVoxelOnce(change);
}

TEST(Scalpel, StopsAtItsDepth) {
  const auto grid = obliqueGrid();
  const auto centre = at(grid, 32, 30, 28);
  const Mask ball = ballMask(grid, centre, 18);
  const auto view = fromTheRight(centre.mm);
  const auto change = cut(ball, view, {{-6, -6}, {6, -6}, {6, 6}, {-6, 6}}, 6.0);
  double deepest = 0, shallowest = 0;
  for (const auto v : change.voxels) {
    const int row = grid.size[0], column = grid.size[1];
    const Eigen::Vector3d p = at(grid, v % row, v / row % column, v / row / column).mm - centre.mm;
    const double skin = std::sqrt(18 * 18 - p.tail<2>().squaredNorm());
    deepest = std::max(deepest, skin - p.x());
    shallowest = std::max(shallowest, p.x());
  }
  EXPECT_GT(shallowest, 16.5);
  EXPECT_NEAR(deepest, 6.0, 1.6);  // tolerance: one voxel
  EXPECT_TRUE(after(ball, change).at(32, 30, 28));
}

}  // namespace
}  // namespace facenav::editing
