#include "facenav/scene/slice_scene.h"

#include <gtest/gtest.h>

namespace facenav::scene {
namespace {

/// Volume of 40 x 50 x 60 mm of air with a bright block on the patient's left. It is stored with x to the
/// left (like LPS scans), so that a picture that ignores the flip shows the block on the wrong side.
std::shared_ptr<volume::Volume> leftBlock() {
  auto mri = std::make_shared<volume::Volume>();
  mri->grid.size = {40, 50, 60};
  mri->grid.mri_from_voxel.linear() = Eigen::Vector3d(-1, 1, 1).asDiagonal();
  mri->grid.mri_from_voxel.translation() = Eigen::Vector3d(20, -25, -30);
  mri->voxels.assign(mri->grid.count(), 0.f);
  for (int k = 20; k < 40; ++k)
    for (int j = 15; j < 35; ++j)
      for (int i = 28; i < 36; ++i) mri->voxels[mri->grid.index(i, j, k)] = 200.f;  // x = -8 .. -15: left
  return mri;
}

double meanRed(const RgbImage& image, int u0, int u1) {
  double sum = 0;
  for (int v = 0; v < image.height_px; ++v)
    for (int u = u0; u < u1; ++u) sum += image.pixel(u, v)[0];
  return sum / (image.height_px * (u1 - u0));
}

TEST(SliceScene, ShowsThePatientsLeftOnTheImagesRight) {
  SliceScene scene;
  scene.mri = leftBlock();
  scene.has_letters = false;
  for (auto orientation : {volume::Anatomical::axial, volume::Anatomical::coronal}) {
    const auto plane = volume::anatomicalPlane(scene.mri->grid, orientation, scene.mri->grid.centre());
    const RgbImage image = scene.picture(plane);
    const int half = image.width_px / 2;
    EXPECT_LT(meanRed(image, 0, half), 0.5);
    EXPECT_GT(meanRed(image, half, image.width_px), 20.0);
  }
}

TEST(SliceScene, LettersNameThePatientsSides) {
  EXPECT_EQ(sideLetter(Direction<Mri>({1, 0.2, 0.1})), 'R');
  EXPECT_EQ(sideLetter(Direction<Mri>({-1, 0.2, 0.1})), 'L');
  EXPECT_EQ(sideLetter(Direction<Mri>({0, 1, 0})), 'A');
  EXPECT_EQ(sideLetter(Direction<Mri>({0, -1, 0.3})), 'P');
  EXPECT_EQ(sideLetter(Direction<Mri>({0, 0, 1})), 'S');
  EXPECT_EQ(sideLetter(Direction<Mri>({0, 0.4, -1})), 'I');
}

TEST(SliceScene, DrawsTheMasksContourAtItsEdge) {
  SliceScene scene;
  scene.mri = leftBlock();
  scene.has_letters = false;
  auto mask = std::make_shared<volume::Mask>();
  mask->grid = scene.mri->grid;
  for (float value : scene.mri->voxels) mask->voxels.push_back(value > 100);
  scene.mri = nullptr;
  scene.contours = {{mask, {0.0, 1.0, 0.0}}};
  const auto plane =
      volume::anatomicalPlane(mask->grid, volume::Anatomical::axial, mask->grid.centre(), 0.25);
  const RgbImage image = scene.picture(plane);
  // The block's edge at x = -7.5 mm (half way between the voxels at -8 and -7), y = 0.
  const Eigen::Vector3d edge = plane.toPixel(Point<Mri>(-7.5, 0, 0)),
                        inside = plane.toPixel(Point<Mri>(-11, 0, 0));
  EXPECT_GT(image.pixel(int(std::lround(edge.x())), int(std::lround(edge.y())))[1], 200);
  EXPECT_EQ(image.pixel(int(std::lround(inside.x())), int(std::lround(inside.y())))[1], 0);
}

TEST(SliceScene, DrawsOnlyPointsNearThePlane) {
  SliceScene scene;
  scene.has_letters = false;
  scene.points.points_mm = {{0, 0, 0.4}, {10, 0, 5.0}};
  const auto plane =
      volume::anatomicalPlane(leftBlock()->grid, volume::Anatomical::axial, Point<Mri>(0, 0, 0), 0.5);
  const RgbImage image = scene.picture(plane);
  const auto red = [&](const Point<Mri>& p) {
    const Eigen::Vector3d px = plane.toPixel(p);
    return int(image.pixel(int(std::lround(px.x())), int(std::lround(px.y())))[0]);
  };
  EXPECT_GT(red(Point<Mri>(0, 0, 0)), 120);
  EXPECT_EQ(red(Point<Mri>(10, 0, 0)), 0);
}

TEST(SlicePosition, IsTheDistanceFromTheOriginAndTheSide) {
  volume::VoxelGrid grid;
  grid.size = {200, 200, 200};
  grid.mri_from_voxel.translation() << -100, -100, -100;
  const auto at = [&](volume::Anatomical orientation, const Point<Mri>& through) {
    return positionOf(volume::anatomicalPlane(grid, orientation, through));
  };
  EXPECT_EQ(at(volume::Anatomical::axial, Point<Mri>(1, 2, 12.3)).side, 'S');
  EXPECT_NEAR(at(volume::Anatomical::axial, Point<Mri>(1, 2, 12.3)).distance_mm, 12.3, 1e-9);
  EXPECT_EQ(at(volume::Anatomical::axial, Point<Mri>(1, 2, -3)).side, 'I');
  EXPECT_EQ(at(volume::Anatomical::coronal, Point<Mri>(0, -7, 0)).side, 'P');
  EXPECT_NEAR(at(volume::Anatomical::coronal, Point<Mri>(0, -7, 0)).distance_mm, 7, 1e-9);
  EXPECT_EQ(at(volume::Anatomical::sagittal, Point<Mri>(-37, 0, 0)).side, 'L');
  EXPECT_EQ(at(volume::Anatomical::sagittal, Point<Mri>(37, 0, 0)).side, 'R');
}

TEST(SliceScene, LettersFollowTheTextScale) {
  SliceScene scene;
  scene.mri = leftBlock();
  auto plane = volume::anatomicalPlane(scene.mri->grid, volume::Anatomical::axial, scene.mri->grid.centre());
  plane.origin = Point<Mri>(500, 500, 500);  // outside the scan: letters only
  plane.width = plane.height = 400;
  const auto brightRows = [&] {
    const RgbImage image = scene.picture(plane);
    int rows = 0;
    for (int v = 100; v < 300; ++v) {
      bool is_bright = false;
      for (int u = 0; u < image.width_px; ++u) is_bright |= image.pixel(u, v)[0] > 120;
      rows += is_bright;
    }
    return rows;  // height of the letters left and right
  };
  const int usual = brightRows();
  ASSERT_GT(usual, 10);
  scene.text_scale = 2.0;
  EXPECT_NEAR(brightRows(), 2 * usual, 4);
}

}  // namespace
}  // namespace facenav::scene
