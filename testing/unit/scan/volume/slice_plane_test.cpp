#include "facenav/volume/slice_plane.h"

#include <gtest/gtest.h>

#include "support/matchers.h"
#include "volumes.h"

namespace facenav::testing {
namespace {

using volume::Anatomical;

TEST(SlicePlane, PixelAndPointAreEachOthersInverse) {
  const auto plane =
      volume::anatomicalPlane(numberedVolume().grid, Anatomical::coronal, Point<Mri>(1, 2, 3), 0.7);
  EXPECT_THAT(plane.toPixel(plane.toMri(3.5, 4.25)), EigenNear(Eigen::Vector3d(3.5, 4.25, 0), 1e-9));
}

TEST(SlicePlane, AnatomicalPlanesAreRadiological) {
  const auto grid = numberedVolume().grid;
  const auto axial = volume::anatomicalPlane(grid, Anatomical::axial, grid.centre());
  EXPECT_THAT(axial.right.v,
              EigenNear(Eigen::Vector3d(-1, 0, 0), 1e-12));  // the patient's right on the image's left
  EXPECT_THAT(axial.down.v, EigenNear(Eigen::Vector3d(0, -1, 0), 1e-12));
  const auto coronal = volume::anatomicalPlane(grid, Anatomical::coronal, grid.centre());
  EXPECT_THAT(coronal.right.v, EigenNear(Eigen::Vector3d(-1, 0, 0), 1e-12));
  EXPECT_THAT(coronal.down.v, EigenNear(Eigen::Vector3d(0, 0, -1), 1e-12));
  const auto sagittal = volume::anatomicalPlane(grid, Anatomical::sagittal, grid.centre());
  EXPECT_NEAR(std::abs(sagittal.right.v.y()), 1, 1e-12);
  EXPECT_THAT(sagittal.down.v, EigenNear(Eigen::Vector3d(0, 0, -1), 1e-12));
}

TEST(SampleSlice, GivesTheValuesOfTheVolumeAtItsPoints) {
  const auto volume = numberedVolume();
  const auto plane = volume::anatomicalPlane(volume.grid, Anatomical::axial, volume.grid.centre(), 0.5);
  const auto values = volume::sampleSlice(volume, plane);
  ASSERT_EQ(values.size(), std::size_t(plane.width) * plane.height);
  int inside = 0;
  for (int v = 0; v < plane.height; ++v)
    for (int u = 0; u < plane.width; ++u) {
      const float expected = volume::sampleLinear(volume, volume.grid.toVoxel(plane.toMri(u, v)));
      EXPECT_NEAR(values[std::size_t(v) * plane.width + u], expected, 0.05);
      inside += expected > 0;
    }
  EXPECT_GT(inside, 50);
}

TEST(SliceNumber, CountsTheFilesOwnSlicesFromOneAndKnowsWhatLiesOutside) {
  volume::VoxelGrid grid;  // stored as sagittal slices from left to right, 2 mm apart
  grid.size = {40, 50, 30};
  grid.mri_from_voxel.linear() << 0, 0, 2, 1, 0, 0, 0, 1, 0;
  grid.mri_from_voxel.translation() << -29, -20, -25;
  const auto at = [&](Anatomical orientation, const Point<Mri>& through) {
    return volume::sliceNumber(grid, volume::anatomicalPlane(grid, orientation, through));
  };
  EXPECT_EQ(at(Anatomical::sagittal, Point<Mri>(-29, 0, 0)).number, 1);
  EXPECT_EQ(at(Anatomical::sagittal, Point<Mri>(-24.6, 0, 0)).number, 3);
  EXPECT_EQ(at(Anatomical::sagittal, Point<Mri>(0, 0, 0)).count, 30);
  EXPECT_EQ(at(Anatomical::coronal, Point<Mri>(0, -20, 0)).number, 1);
  EXPECT_EQ(at(Anatomical::coronal, Point<Mri>(0, 19, 0)).number, 40);
  EXPECT_EQ(at(Anatomical::axial, Point<Mri>(0, 0, 0)).number, 26);
  EXPECT_EQ(at(Anatomical::axial, Point<Mri>(0, 0, 0)).count, 50);
  EXPECT_EQ(at(Anatomical::axial, Point<Mri>(0, 0, 40)).number, 0);
}

TEST(ValueAt, IsThatOfTheNearestVoxelAndNothingOutside) {
  const auto mri = numberedVolume();
  const Eigen::Vector3d ijk(1, 0, 1);
  EXPECT_EQ(volume::valueAt(mri, mri.grid.toMri(ijk + Eigen::Vector3d(0.4, -0.4, 0.3))), mri.at(1, 0, 1));
  EXPECT_FALSE(volume::valueAt(mri, mri.grid.toMri(Eigen::Vector3d(0, 0, -0.6))));
  EXPECT_FALSE(volume::valueAt(mri, mri.grid.toMri(Eigen::Vector3d(mri.grid.size[0], 0, 0))));
}

}  // namespace
}  // namespace facenav::testing
