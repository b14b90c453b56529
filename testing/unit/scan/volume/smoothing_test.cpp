#include "facenav/volume/smoothing.h"

#include <gtest/gtest.h>

namespace facenav::volume {
namespace {

/// A Gaussian blob that is nearly 0 at the borders.
Volume blob(double variance) {
  Volume volume;
  volume.grid.size = {25, 25, 25};
  volume.voxels.resize(volume.grid.count());
  for (int k = 0; k < 25; ++k)
    for (int j = 0; j < 25; ++j)
      for (int i = 0; i < 25; ++i)
        volume.voxels[volume.grid.index(i, j, k)] =
            float(std::exp(-0.5 * Eigen::Vector3d(i - 12, j - 12, k - 12).squaredNorm() / variance));
  return volume;
}

Eigen::Vector3d secondMoments(const Volume& volume) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double total = 0;
  for (int k = 0; k < 25; ++k)
    for (int j = 0; j < 25; ++j)
      for (int i = 0; i < 25; ++i) {
        const Eigen::Array3d p(i - 12, j - 12, k - 12);
        sum += (double(volume.at(i, j, k)) * p.square()).matrix();
        total += volume.at(i, j, k);
      }
  return sum / total;
}

TEST(Smoothing, AddsTheVarianceItIsAskedForAlongEachAxis) {
  const Volume before = blob(2);
  const Eigen::Vector3d variance(0.3, -0.2, 0.5);
  const Eigen::Vector3d added = secondMoments(spread(before, variance)) - secondMoments(before);
  EXPECT_LT((added - variance).norm(), 1e-3);
}

TEST(Smoothing, NegativeVarianceBringsBackWhatPositiveTook) {
  const Volume sharp = blob(2), wide = spread(sharp, Eigen::Vector3d::Constant(0.3));
  const Volume back = spread(wide, Eigen::Vector3d::Constant(-0.3));
  const auto centre = sharp.grid.index(12, 12, 12);
  EXPECT_GT(sharp.voxels[centre] - wide.voxels[centre], 0.15);
  EXPECT_NEAR(back.voxels[centre], sharp.voxels[centre], 0.05);
}

TEST(Smoothing, LeavesAFlatVolumeAlone) {
  Volume flat = blob(2);
  for (float& value : flat.voxels) value = 7;
  for (const float value : spread(flat, Eigen::Vector3d(0.5, -0.3, 0.1)).voxels) ASSERT_NEAR(value, 7, 1e-5);
}

}  // namespace
}  // namespace facenav::volume
