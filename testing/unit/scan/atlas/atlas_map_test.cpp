#include "facenav/atlas/atlas_map.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "facenav/core/error.h"
#include "support/test_data.h"

namespace facenav::atlas {
namespace {

/// A smooth warp of up to 6 mm on a 4 mm grid, after a rotated, scaled, shifted affine.
AtlasMap madeMap() {
  volume::VoxelGrid grid;
  grid.size = {30, 34, 28};
  grid.mri_from_voxel = Eigen::Translation3d(-58, -66, -54) * Eigen::Scaling(4.0);
  std::vector<Eigen::Vector3f> displacement_mm;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i)
        displacement_mm.emplace_back(6 * std::sin(0.15 * j), 5 * std::cos(0.12 * k), -4 * std::sin(0.17 * i));
  const Eigen::Affine3d affine = Eigen::Translation3d(5, -12, 20) *
                                 Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, -1).normalized()) *
                                 Eigen::Scaling(0.9, 1.1, 1.05);
  return AtlasMap(affine, grid, std::move(displacement_mm));
}

TEST(AtlasMap, ThereAndBackIsTheSamePlace) {
  const auto map = madeMap();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> within(-80, 80);  // includes points beyond the grid
  for (int n = 0; n < 500; ++n) {
    const Point<Mni> p(within(random), within(random), within(random));
    EXPECT_LT((map.toMni(map.toMri(p)).mm - p.mm).norm(), 0.05) << p.mm.transpose();
  }
}

TEST(AtlasMap, GoesOnWithoutAStepBeyondItsGrid) {
  const auto map = madeMap();
  for (const double x_mm : {-58.0, 58.0}) {  // the grid's first and last plane
    const auto inside = map.toMri(Point<Mni>(x_mm - 0.01, 10, 5)),
               outside = map.toMri(Point<Mni>(x_mm + 0.01, 10, 5));
    EXPECT_LT((inside.mm - outside.mm).norm(), 0.1);
  }
}

TEST(AtlasMap, AFileKeepsItToAHundredthOfAMillimetre) {
  const testing::TemporaryFolder folder;
  const auto map = madeMap();
  writeAtlasMap(map, folder.path() / "atlas.vti");
  const auto read = readAtlasMap(folder.path() / "atlas.vti");
  for (const Point<Mni>& p : {Point<Mni>(-37, -21, 40), Point<Mni>(11, 52, -30), Point<Mni>(0, 0, 0)})
    EXPECT_LT((read.toMri(p).mm - map.toMri(p).mm).norm(), 0.02);
}

TEST(AtlasMap, ADamagedOrMissingFileIsAnErrorThatNamesIt) {
  const testing::TemporaryFolder folder;
  const auto path = folder.path() / "atlas.vti";
  EXPECT_THROW(readAtlasMap(path), Error);
  std::ofstream(path) << "not an image";
  EXPECT_THROW(readAtlasMap(path), Error);
}

TEST(AtlasMap, AMirroredAffineIsRefused) {
  const testing::TemporaryFolder folder;
  const auto map = madeMap();
  Eigen::Affine3d mirrored = map.affine();
  mirrored.linear().col(0) *= -1;
  writeAtlasMap(AtlasMap(mirrored, map.grid(), map.displacement_mm()), folder.path() / "atlas.vti");
  EXPECT_THROW(readAtlasMap(folder.path() / "atlas.vti"), Error);
}

}  // namespace
}  // namespace facenav::atlas
