#include <gtest/gtest.h>

#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/volume/volume.h"
#include "facenav/volume/voxel_storage.h"
#include "support/matchers.h"
#include "volumes.h"

namespace facenav::testing {
namespace {

TEST(VoxelStorage, HoldsZerosOfAnySize) {
  for (const std::size_t count : {std::size_t(0), std::size_t(5), std::size_t(3'000'001)}) {
    const auto voxels = volume::voxelStorage(count);
    ASSERT_EQ(voxels.size(), count);
    EXPECT_TRUE(std::all_of(voxels.begin(), voxels.end(), [](float v) { return v == 0.f; }));
  }
}

TEST(VoxelGrid, VoxelAndWorldAreEachOthersInverse) {
  const auto grid = numberedVolume().grid;
  const Eigen::Vector3d ijk(1.25, 3.5, 2);
  EXPECT_THAT(grid.toVoxel(grid.toMri(ijk)), EigenNear(ijk, 1e-12));
  EXPECT_THAT(grid.spacing_mm(), EigenNear(Eigen::Vector3d(1.5, 0.8, 2), 1e-12));
  EXPECT_NEAR(grid.voxelVolume_mm3(), 2.4, 1e-12);
  EXPECT_THAT(grid.toVoxel(grid.centre()), EigenNear(Eigen::Vector3d(2, 2.5, 3), 1e-12));
}

TEST(VoxelGrid, MatchesOnlyWithinAMicrometre) {
  const auto grid = numberedVolume().grid;
  auto moved = grid;
  EXPECT_TRUE(grid.matches(moved));
  moved.mri_from_voxel.translation().x() += 0.002;
  EXPECT_FALSE(grid.matches(moved));
  auto mirrored = grid;
  mirrored.mri_from_voxel.linear().col(0) *= -1;
  EXPECT_FALSE(grid.matches(mirrored));
}

TEST(SampleLinear, IsLinearInsideAndOutsideBeyondTheOutermostCentres) {
  const auto volume = numberedVolume();
  EXPECT_NEAR(volume::sampleLinear(volume, {1.25, 3.5, 2.75}), 1.25 + 35 + 275, 1e-3);
  EXPECT_EQ(volume::sampleLinear(volume, {4, 5, 6}), 4 + 50 + 600);
  EXPECT_EQ(volume::sampleLinear(volume, {4.01, 5, 6}, -7.f), -7.f);
  EXPECT_EQ(volume::sampleLinear(volume, {-0.01, 0, 0}, -7.f), -7.f);
  EXPECT_EQ(volume::sampleLinear(volume, {std::nan(""), 0, 0}, -7.f), -7.f);
}

TEST(SampleLinear, OfAMaskEqualsThatOfItsVolume) {
  auto volume = numberedVolume();
  volume::Mask mask{volume.grid, {}};
  for (float& value : volume.voxels) {
    mask.voxels.push_back(int(value) % 3 == 0);
    value = mask.voxels.back();
  }
  for (double x = -0.5; x < 5; x += 0.3)
    for (double z = -0.5; z < 7; z += 0.4)
      EXPECT_EQ(volume::sampleLinear(mask, {x, 5 - x, z}, -3),
                volume::sampleLinear(volume, {x, 5 - x, z}, -3));
}

TEST(Percentile, OfKnownValuesPassesOverNotANumber) {
  auto volume = numberedVolume();
  volume.voxels.assign(volume.voxels.size(), 5.f);
  for (std::size_t i = 0; i < 100; ++i) volume.voxels[i] = float(i);
  volume.voxels.resize(100);
  EXPECT_NEAR(volume::percentile(volume, 0.25), 25, 1);
  volume.voxels[99] = std::nanf("");
  EXPECT_EQ(volume::percentile(volume, 1.0), 98.f);
}

TEST(Overlap, OfTwoHalfOverlappingBars) {
  volume::Mask a{numberedVolume().grid, std::vector<std::uint8_t>(210, 0)}, b = a;
  for (int i = 0; i < 10; ++i) a.voxels[i] = 1, b.voxels[i + 5] = 1;
  const auto result = volume::overlap(a, b);
  EXPECT_DOUBLE_EQ(result.dice, 0.5);
  EXPECT_DOUBLE_EQ(result.inside, 0.5);
  EXPECT_NEAR(a.volume_ml(), 10 * 2.4 / 1000, 1e-12);
  b.grid.mri_from_voxel.translation().x() += 1;
  EXPECT_THROW(volume::overlap(a, b), Error);
}

}  // namespace
}  // namespace facenav::testing
