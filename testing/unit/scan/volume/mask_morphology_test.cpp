#include "facenav/volume/mask_morphology.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace facenav::volume {
namespace {

Mask emptyMask(int n, double spacing_mm = 1.0) {
  Mask mask;
  mask.grid.size = {n, n, n};
  mask.grid.mri_from_voxel.linear() *= spacing_mm;
  mask.voxels.assign(mask.grid.count(), 0);
  return mask;
}

Mask ball(int n, double radius) {
  Mask mask = emptyMask(n);
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        mask.voxels[mask.grid.index(i, j, k)] = std::hypot(i - n / 2, j - n / 2, k - n / 2) <= radius;
  return mask;
}

std::size_t countOf(const Mask& mask) { return std::count(mask.voxels.begin(), mask.voxels.end(), 1); }

TEST(MaskMorphology, DistanceEqualsTheBruteForceSearch) {
  Mask mask = emptyMask(14, 0.8);
  std::mt19937 random(5);
  for (int n = 0; n < 12; ++n) mask.voxels[random() % mask.voxels.size()] = 1;
  const auto distance = distanceTo(mask);
  const auto& g = mask.grid;
  for (int k = 0; k < 14; ++k)
    for (int j = 0; j < 14; ++j)
      for (int i = 0; i < 14; ++i) {
        double nearest = 1e9;
        for (int c = 0; c < 14; ++c)
          for (int b = 0; b < 14; ++b)
            for (int a = 0; a < 14; ++a)
              if (mask.at(a, b, c)) nearest = std::min(nearest, 0.8 * std::hypot(i - a, j - b, k - c));
        ASSERT_NEAR(distance[g.index(i, j, k)], nearest, 1e-4);
      }
}

TEST(MaskMorphology, DistanceIsInMillimetresOnUnequalSpacing) {
  Mask mask = emptyMask(12);
  mask.grid.mri_from_voxel.linear() = Eigen::Vector3d(0.7, 1.0, 2.5).asDiagonal();
  const std::array<int, 3> from{3, 8, 2};
  mask.voxels[mask.grid.index(from[0], from[1], from[2])] = 1;
  const auto distance = distanceTo(mask);
  for (int k = 0; k < 12; ++k)
    for (int j = 0; j < 12; ++j)
      for (int i = 0; i < 12; ++i)
        ASSERT_NEAR(distance[mask.grid.index(i, j, k)], std::hypot(0.7 * (i - 3), j - 8, 2.5 * (k - 2)),
                    1e-4);
}

TEST(MaskMorphology, DilationAndErosionEqualTheirDefinitionAtAnyRadius) {
  Mask mask = emptyMask(23);
  mask.grid.mri_from_voxel.linear() = Eigen::Vector3d(0.7, 1.0, 1.4).asDiagonal();
  std::mt19937 random(9);
  for (auto& voxel : mask.voxels) voxel = random() % 200 == 0;
  Mask rest = mask;
  for (auto& voxel : rest.voxels) voxel = !voxel;
  const auto distance = distanceTo(mask);
  for (double radius_mm : {0.5, 1.0, 1.4, 2.1, 3.0, 4.0, 30.0}) {
    const Mask wide = dilate(mask, radius_mm), narrow = erode(rest, radius_mm);
    for (std::size_t v = 0; v < distance.size(); ++v) {
      ASSERT_EQ(wide.voxels[v] != 0, distance[v] <= radius_mm + 1e-5) << radius_mm;
      ASSERT_EQ(narrow.voxels[v] != 0, distance[v] > radius_mm + 1e-5) << radius_mm;
    }
  }
}

TEST(MaskMorphology, DilationAndErosionHoldInRowsOfAnyLength) {
  std::mt19937 random(17);
  for (const int length : {1, 63, 64, 65, 131}) {
    Mask mask;
    mask.grid.size = {length, 6, 5};
    mask.grid.mri_from_voxel.linear() = Eigen::Vector3d(0.9, 1.3, 0.7).asDiagonal();
    for (std::size_t v = 0; v < mask.grid.count(); ++v) mask.voxels.push_back(random() % 40 == 0 ? 255 : 0);
    Mask rest = mask;
    for (auto& voxel : rest.voxels) voxel = !voxel;
    const auto distance = distanceTo(mask);
    for (double radius_mm : {0.8, 1.9, 3.1, 7.0, 20.0}) {
      const Mask wide = dilate(mask, radius_mm), narrow = erode(rest, radius_mm);
      for (std::size_t v = 0; v < distance.size(); ++v) {
        ASSERT_EQ(wide.voxels[v], distance[v] <= radius_mm) << length << " " << radius_mm;
        ASSERT_EQ(narrow.voxels[v], distance[v] > radius_mm) << length << " " << radius_mm;
      }
    }
  }
}

TEST(MaskMorphology, NothingAndAllStayWhatTheyAre) {
  Mask none = emptyMask(9), all = none;
  all.voxels.assign(all.voxels.size(), 1);
  EXPECT_EQ(countOf(dilate(none, 3)), 0u);
  EXPECT_EQ(countOf(erode(none, 3)), 0u);
  EXPECT_EQ(countOf(dilate(all, 3)), all.voxels.size());
  EXPECT_EQ(countOf(erode(all, 3)), all.voxels.size()) << "beyond the grid lies nothing that erodes";
}

TEST(MaskMorphology, HolesAreFilledFromTheOutsideThatIsNamed) {
  Mask wall = emptyMask(8);
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 8; ++j) wall.voxels[wall.grid.index(4, j, k)] = 1;
  const Mask left = fillHolesFrom(wall, {wall.grid.index(0, 3, 3), wall.grid.index(4, 0, 0)});
  EXPECT_EQ(left.at(3, 7, 0), 0);
  EXPECT_EQ(left.at(5, 0, 0), 1) << "a voxel of the mask is no way in";
  EXPECT_EQ(countOf(left), 4u * 8 * 8);
  EXPECT_EQ(countOf(fillHoles(wall)), 8u * 8) << "both sides are open to the border";
}

TEST(MaskMorphology, ErosionUndoesDilationOfABall) {
  const auto small = ball(41, 8), large = ball(41, 12);
  EXPECT_GE(overlap(dilate(small, 4), large).dice, 0.95);
  EXPECT_GE(overlap(erode(large, 4), small).dice, 0.95);
}

TEST(MaskMorphology, ClosingFillsASlitAndOpeningCutsAThread) {
  Mask slit = ball(41, 14);
  for (int k = 20; k < 41; ++k)
    for (int j = 0; j < 41; ++j)
      for (int i = 19; i <= 21; ++i) slit.voxels[slit.grid.index(i, j, k)] = 0;
  EXPECT_TRUE(close(slit, 2.5).at(20, 20, 26));
  Mask thread = ball(41, 10);
  for (int k = 0; k < 41; ++k) thread.voxels[thread.grid.index(20, 20, k)] = 1;
  EXPECT_FALSE(open(thread, 2).at(20, 20, 2));
  EXPECT_TRUE(open(thread, 2).at(20, 20, 20));
}

TEST(MaskMorphology, KeepsTheLargestPartAndFillsHoles) {
  Mask mask = ball(41, 9);
  mask.voxels[mask.grid.index(1, 1, 1)] = 1;
  mask.voxels[mask.grid.index(20, 20, 20)] = 0;
  const std::size_t whole = countOf(mask);
  EXPECT_EQ(countOf(largestPart(mask)), whole - 1);
  EXPECT_EQ(countOf(fillHoles(mask)), whole + 1);
}

}  // namespace
}  // namespace facenav::volume
