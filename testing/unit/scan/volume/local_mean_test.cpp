#include "facenav/volume/local_mean.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

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

/// Local mean by its definition: three times, along each axis, the mean over the box.
std::vector<float> boxed(const VoxelGrid& grid, std::vector<float> values, double reach_mm) {
  const std::array<int, 3> step{1, grid.size[0], grid.size[0] * grid.size[1]};
  for (int axis = 0; axis < 3; ++axis)
    for (int pass = 0; pass < 3; ++pass) {
      const auto before = values;
      const int half = std::max(1, int(std::lround(0.5 * reach_mm / grid.spacing_mm()[axis])));
      for (int v = 0; v < int(values.size()); ++v) {
        const int at = v / step[axis] % grid.size[axis];
        double sum = 0;
        int count = 0;
        for (int d = -half; d <= half; ++d)
          if (at + d >= 0 && at + d < grid.size[axis]) sum += before[v + d * step[axis]], ++count;
        values[v] = float(sum / count);
      }
    }
  return values;
}

TEST(LocalMean, EqualsItsDefinitionOnAnyGrid) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> value(10, 20);
  for (const std::array<int, 3> size : {std::array<int, 3>{37, 18, 5}, {16, 33, 12}, {3, 1, 40}}) {
    VoxelGrid grid;
    grid.size = size;
    grid.mri_from_voxel.linear() = Eigen::Vector3d(1, 0.7, 1.9).asDiagonal();
    std::vector<float> values(grid.count()), chosen(grid.count()), weight(grid.count());
    std::vector<std::uint8_t> counts(grid.count());
    for (std::size_t v = 0; v < values.size(); ++v) {
      values[v] = value(random), counts[v] = random() % 3 == 0;
      if (counts[v]) chosen[v] = values[v], weight[v] = 1;
    }
    const auto mean = localMean(grid, values, counts, 4, -1);
    const auto sum = boxed(grid, chosen, 4), share = boxed(grid, weight, 4);
    for (std::size_t v = 0; v < mean.size(); ++v)
      ASSERT_NEAR(mean[v], share[v] > 1e-3f ? sum[v] / share[v] : -1, 1e-3) << v;
  }
}

}  // namespace
}  // namespace facenav::volume
