#include "facenav/volume/local_mean.h"

#include <gtest/gtest.h>

namespace facenav::volume {
namespace {

VoxelGrid line(int count, double spacing_mm) {
  VoxelGrid grid;
  grid.size = {count, 1, 1};
  grid.mri_from_voxel.linear() *= spacing_mm;
  return grid;
}

TEST(LocalMean, CountsOnlyTheChosenVoxels) {
  const VoxelGrid grid = line(41, 1);
  std::vector<float> values(41, 7.f);
  std::vector<std::uint8_t> counts(41, 1);
  for (int i = 15; i < 26; ++i) values[i] = 1000, counts[i] = 0;
  for (const float mean : localMean(grid, values, counts, 10, -1)) EXPECT_NEAR(mean, 7, 1e-4);
}

TEST(LocalMean, GivesTheOtherValueWhereNothingIsNear) {
  std::vector<std::uint8_t> counts(101, 0);
  counts[0] = 1;
  const auto mean = localMean(line(101, 1), std::vector<float>(101, 3.f), counts, 8, -1);
  EXPECT_FLOAT_EQ(mean[0], 3);
  EXPECT_FLOAT_EQ(mean[100], -1);
}

TEST(LocalMean, ReachIsInMillimetres) {
  for (const double spacing : {1.0, 2.0}) {
    const int count = int(160 / spacing) + 1;
    std::vector<float> values(count);
    for (int i = 0; i < count; ++i) values[i] = i * spacing < 80 ? 0.f : 1.f;
    const auto mean = localMean(line(count, spacing), values, std::vector<std::uint8_t>(count, 1), 16, 0);
    // Three boxes of 16 mm: a bell of sigma 8 mm.
    EXPECT_NEAR(mean[int(88 / spacing)], 0.84, 0.04) << spacing;
    EXPECT_NEAR(mean[int(104 / spacing)], 1, 0.01) << spacing;
  }
}

}  // namespace
}  // namespace facenav::volume
