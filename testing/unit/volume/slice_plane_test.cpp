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

}  // namespace
}  // namespace facenav::testing
