#include "facenav/prepare/finding_place.h"

#include <gtest/gtest.h>

namespace facenav::steps {
namespace {

/// A skin of six vertices, one at each end.
surface::ScalpSurface sixEnds() {
  surface::ScalpSurface scalp;
  scalp.mesh.vertices_mm = {{80, 0, 0}, {-80, 0, 0}, {0, 100, 0}, {0, -100, 0}, {0, 0, 90}, {0, 0, -90}};
  return scalp;
}

atlas::AtlasMap shifted() {
  volume::VoxelGrid grid;
  grid.size = {2, 2, 2};
  Eigen::Affine3d mri_from_mni = Eigen::Affine3d::Identity();
  mri_from_mni.translation() = Eigen::Vector3d(0, 0, 10);
  return {mri_from_mni, grid, std::vector<Eigen::Vector3f>(8, Eigen::Vector3f::Zero())};
}

Eigen::Vector3d placeOf(const std::string& finding) {
  const auto atlas = shifted();
  const auto place = placeOfFinding(finding, sixEnds(), &atlas);
  return place ? place->mm : Eigen::Vector3d::Zero();
}

TEST(FindingPlace, OfHeadAndFace) {
  EXPECT_EQ(placeOf("the nose tip is cut by the scan's edge"), Eigen::Vector3d(0, 100, 0));
  EXPECT_EQ(placeOf("the face was removed below the brow"), Eigen::Vector3d(0, 100, 0));
  EXPECT_EQ(placeOf("vertex, caution: the top of the head is cut over 12 cm2"), Eigen::Vector3d(0, 0, 90));
  EXPECT_EQ(placeOf("ears, caution: the left side of the head is cut"), Eigen::Vector3d(-80, 0, 0));
  EXPECT_EQ(placeOf("an ear is cut by the scan's edge"), Eigen::Vector3d(80, 0, 0));
}

TEST(FindingPlace, OfTheBrainsRegionsByTheAtlas) {
  const std::string rest = ": the mask's edge is uncertain by 4 mm there (confidence 0.62)";
  EXPECT_EQ(placeOf("look at the left temporal pole" + rest), Eigen::Vector3d(-42, 14, -20));
  EXPECT_EQ(placeOf("look at the right temporal lobe" + rest), Eigen::Vector3d(58, -24, 4));
  EXPECT_FALSE(placeOfFinding("look at the left temporal pole" + rest, sixEnds(), nullptr));
}

TEST(FindingPlace, NoneForTheWholeScan) {
  const auto atlas = shifted();
  EXPECT_FALSE(placeOfFinding("voxels of 0.90 to 1.30 mm", sixEnds(), &atlas));
}

}  // namespace
}  // namespace facenav::steps
