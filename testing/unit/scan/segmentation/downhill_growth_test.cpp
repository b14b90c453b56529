#include "downhill_growth.h"

#include <gtest/gtest.h>

#include <string>

// Growth along a row of voxels whose values are known.

namespace facenav::segmentation {
namespace {

/// Grows along a row through the middle of a grid, whose values (hundredths) are given; all other voxels are
/// blocked. The row's first voxel is the seed. Returns one digit per voxel: 1 if it was reached.
std::string reached(const std::vector<float>& values, double rise = 0.05) {
  volume::Volume image;
  image.grid.size = {int(values.size()) + 2, 3, 3};
  image.voxels.assign(image.grid.count(), 0);
  volume::Mask within{image.grid, std::vector<std::uint8_t>(image.grid.count())}, seed = within;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t at = image.grid.index(int(i) + 1, 1, 1);
    image.voxels[at] = values[i], within.voxels[at] = 1, seed.voxels[at] = i == 0;
  }
  const volume::Mask grown = growDownhill(image, seed, within, {0, 100, rise});
  std::string row;
  for (std::size_t i = 0; i < values.size(); ++i) row += grown.at(int(i) + 1, 1, 1) ? '1' : '0';
  return row;
}

TEST(DownhillGrowth, ReachesAllThatOnlyGrowsDarker) {
  EXPECT_EQ(reached({100, 90, 70, 70, 40, 1}), "111111");
}

TEST(DownhillGrowth, StopsWhereTheImageGrowsBrighterAgain) {
  EXPECT_EQ(reached({100, 80, 50, 60, 80, 80}), "111000");
}

TEST(DownhillGrowth, PassesOverNoise) { EXPECT_EQ(reached({90, 94, 70, 74, 71, 60}), "111111"); }

TEST(DownhillGrowth, IsNotLedUpByManySmallSteps) {
  EXPECT_EQ(reached({100, 50, 54, 58, 62, 66, 70}), "1110000");  // each against the darkest before
}

TEST(DownhillGrowth, DoesNotMindWhatLiesAboveTheRangesTop) {
  EXPECT_EQ(reached({130, 105, 150, 99, 180}), "11111");
}

TEST(DownhillGrowth, TakesTheBrightestOfAllPaths) {
  // A dark row beside a bright one, both from the seed to a bright end.
  volume::Volume image;
  image.grid.size = {5, 4, 3};
  image.voxels.assign(image.grid.count(), 0);
  volume::Mask within{image.grid, std::vector<std::uint8_t>(image.grid.count())}, seed = within;
  for (int j = 1; j < 3; ++j)
    for (int i = 1; i < 4; ++i) {
      const std::size_t at = image.grid.index(i, j, 1);
      within.voxels[at] = 1, image.voxels[at] = j == 1 && i == 2 ? 30.f : 80.f;
    }
  seed.voxels[image.grid.index(1, 1, 1)] = 1;
  EXPECT_EQ(growDownhill(image, seed, within, {0, 100, 0.05}).voxels, within.voxels);
}

}  // namespace
}  // namespace facenav::segmentation
