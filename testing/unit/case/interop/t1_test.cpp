#include "facenav/interop/t1.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "two_forms.h"

namespace facenav::interop {
namespace {

using namespace interop::testing;

/// Returns the same voxels with the axes in another order, some of them reversed.
volume::VoxelGrid reordered(const volume::VoxelGrid& grid, const std::array<int, 3>& order, int reversed) {
  volume::VoxelGrid result = grid;
  for (int axis = 0; axis < 3; ++axis) {
    const int from = order[std::size_t(axis)];
    const Eigen::Vector3d step = grid.mri_from_voxel.linear().col(from);
    result.size[std::size_t(axis)] = grid.size[std::size_t(from)];
    const bool is_reversed = (reversed >> axis) & 1;
    result.mri_from_voxel.linear().col(axis) = is_reversed ? Eigen::Vector3d(-step) : step;
    if (is_reversed) result.mri_from_voxel.translation() += step * (grid.size[std::size_t(from)] - 1);
  }
  return result;
}

TEST(T1, IsTheSameInRasOrderHoweverItsVoxelsAreStored) {
  const auto ras = canonical(readT1(made("t1_lpi.nii.gz")).grid);
  EXPECT_GT(ras.mri_from_voxel.linear().diagonal().minCoeff(), 0.0);
  std::array<int, 3> order{0, 1, 2};
  do {
    for (int reversed = 0; reversed < 8; ++reversed) {
      const auto stored = reordered(ras, order, reversed);
      EXPECT_TRUE(canonical(stored).matches(ras)) << order[0] << order[1] << order[2] << " " << reversed;
      EXPECT_TRUE(canonicalOf(stored.mri_from_voxel, ras).matches(ras));
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(T1, ItsQformNumbersGiveItsQform) {
  const facenav::testing::TemporaryFolder folder;
  for (const auto& t1 : {readT1(made("t1_lpi.nii.gz")), writeTwoForms(folder.path() / "two.nii")})
    EXPECT_LT(cornersApart_mm(t1.qform_numbers.affine(), *t1.qform, t1.grid.size), 1e-3);
}

}  // namespace
}  // namespace facenav::interop
