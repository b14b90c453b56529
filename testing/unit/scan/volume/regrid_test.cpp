#include "facenav/volume/regrid.h"

#include <gtest/gtest.h>

#include "volumes.h"

namespace facenav::testing {
namespace {

/// Stores the voxels in another axis order and direction.
volume::Volume permuted(const volume::Volume& from, const std::array<int, 3>& order, int flips) {
  volume::Volume to = from;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  for (int a = 0; a < 3; ++a) {
    const bool is_flipped = flips >> a & 1;
    to.grid.size[a] = from.grid.size[order[a]];
    to.grid.mri_from_voxel.linear().col(a) =
        from.grid.mri_from_voxel.linear().col(order[a]) * (is_flipped ? -1 : 1);
    if (is_flipped) first[order[a]] = from.grid.size[order[a]] - 1;
  }
  to.grid.mri_from_voxel.translation() = from.grid.mri_from_voxel * first;
  for (int k = 0; k < to.grid.size[2]; ++k)
    for (int j = 0; j < to.grid.size[1]; ++j)
      for (int i = 0; i < to.grid.size[0]; ++i) {
        std::array<int, 3> source{};
        const std::array<int, 3> here{i, j, k};
        for (int a = 0; a < 3; ++a)
          source[order[a]] = flips >> a & 1 ? to.grid.size[a] - 1 - here[a] : here[a];
        to.voxels[to.grid.index(i, j, k)] = from.at(source[0], source[1], source[2]);
      }
  return to;
}

TEST(ToRasOrder, EveryStoredOrderGivesTheSameVolume) {
  const auto expected = numberedVolume();
  for (const auto& order :
       {std::array<int, 3>{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}})
    for (int flips = 0; flips < 8; ++flips) {
      const auto ras = volume::toRasOrder(permuted(expected, order, flips));
      EXPECT_TRUE(ras.grid.matches(expected.grid));
      EXPECT_EQ(ras.voxels, expected.voxels);
    }
}

TEST(Resample, OntoItsOwnGridChangesNothing) {
  const auto volume = numberedVolume();
  const auto same = volume::resample(volume, volume.grid);
  for (std::size_t i = 0; i < volume.voxels.size(); ++i)
    EXPECT_NEAR(same.voxels[i], volume.voxels[i], 1e-3) << i;
}

TEST(Resample, LinearFieldIsReproducedExactlyInside) {
  const auto volume = numberedVolume();
  volume::VoxelGrid finer = volume.grid;  // shifted by half a voxel
  finer.size = {4, 5, 6};
  finer.mri_from_voxel.translation() = volume.grid.mri_from_voxel * Eigen::Vector3d(0.5, 0.5, 0.5);
  const auto moved = volume::resample(volume, finer);
  for (int k = 0; k < 6; ++k)
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(moved.at(i, j, k), (i + .5) + 10 * (j + .5) + 100 * (k + .5), 1e-3);
}

TEST(Resample, MaskKeepsItsVolumeOnAFinerGrid) {
  volume::Mask mask;
  mask.grid.size = {40, 40, 40};
  mask.voxels.resize(mask.grid.count());
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 40; ++i)
        mask.voxels[mask.grid.index(i, j, k)] =
            (Eigen::Vector3d(i, j, k) - Eigen::Vector3d(20, 20, 20)).norm() < 12;
  const auto finer = volume::resample(mask, volume::isotropicGrid(mask.grid, 0.7));
  EXPECT_NEAR(finer.volume_ml() / mask.volume_ml(), 1, 0.02);
}

TEST(Resample, AboveALevelEqualsTheResampledVolumesVoxels) {
  const auto volume = numberedVolume();
  volume::VoxelGrid grid = volume.grid;  // also beyond the volume
  grid.size = {9, 11, 8};
  grid.mri_from_voxel.linear() *= 0.9;
  const auto there = volume::resample(volume, grid);
  for (const float level : {-1.f, 0.f, 213.4f, 1e6f}) {
    const auto mask = volume::resampledAbove(volume, level, grid);
    for (std::size_t v = 0; v < mask.voxels.size(); ++v)
      ASSERT_EQ(mask.voxels[v] != 0, there.voxels[v] >= level) << level;
  }
}

TEST(Resample, AboveAFloorEqualsTheVolumeThatWasLoweredFirst) {
  volume::Volume scan{{{5, 4, 3}, Eigen::Affine3d::Identity()}, {}, {}, {}};
  for (std::size_t v = 0; v < scan.grid.count(); ++v) scan.voxels.push_back(float(v * 37 % 101));
  scan.voxels[7] = std::nanf("");
  volume::Volume lowered = scan;
  for (float& value : lowered.voxels) value = std::isfinite(value) ? value - 12.5f : 0.f;
  const auto grid = volume::isotropicGrid(scan.grid, 0.7);
  EXPECT_EQ(volume::resampleAbove(scan, 12.5f, grid).voxels, volume::resample(lowered, grid).voxels);
}

TEST(Resample, TheShareOfAMaskEqualsTheResampledVolumeOfItsVoxels) {
  volume::Mask mask{{{5, 4, 3}, Eigen::Affine3d::Identity()}, {}};
  for (std::size_t v = 0; v < mask.grid.count(); ++v) mask.voxels.push_back(v * 37 % 101 > 50);
  const volume::Volume same{mask.grid, {mask.voxels.begin(), mask.voxels.end()}, {}, {}};
  const auto grid = volume::isotropicGrid(mask.grid, 0.7);
  EXPECT_EQ(volume::shareOn(mask, grid).voxels, volume::resample(same, grid).voxels);
}

TEST(Resample, CubicKeepsTheGridsOwnValuesAndGivesQuadraticsExactly) {
  volume::Volume coarse{{{12, 11, 10}, Eigen::Affine3d(Eigen::Scaling(1.5))}, {}, {}, {}};
  const auto quadratic = [](const Eigen::Vector3d& p) {
    return p.x() * p.x() - 2 * p.y() * p.y() + p.z() + 3;
  };
  for (int k = 0; k < 10; ++k)
    for (int j = 0; j < 11; ++j)
      for (int i = 0; i < 12; ++i)
        coarse.voxels.push_back(float(quadratic(coarse.grid.toMri(Eigen::Vector3d(i, j, k)).mm)));
  EXPECT_EQ(volume::resampleCubic(coarse, coarse.grid).voxels, coarse.voxels);
  volume::VoxelGrid fine = volume::isotropicGrid(coarse.grid, 0.7);
  const auto values = volume::resampleCubic(coarse, fine);
  for (int k = 4; k < 12; ++k)
    for (int j = 4; j < 12; ++j)
      for (int i = 4; i < 12; ++i)
        ASSERT_NEAR(values.at(i, j, k), quadratic(fine.toMri(Eigen::Vector3d(i, j, k)).mm), 1e-3);
}

TEST(IsotropicGrid, CoversTheWholeGrid) {
  const auto grid = volume::isotropicGrid(numberedVolume().grid, 0.7);
  for (int c = 0; c < 8; ++c) {
    const auto p = numberedVolume().grid.toMri({(c & 1) * 4.0, (c >> 1 & 1) * 5.0, (c >> 2) * 6.0});
    const Eigen::Vector3d ijk = grid.toVoxel(p);
    for (int a = 0; a < 3; ++a) EXPECT_TRUE(ijk[a] >= -1e-9 && ijk[a] <= grid.size[a] - 1 + 1e-9);
  }
}

}  // namespace
}  // namespace facenav::testing
