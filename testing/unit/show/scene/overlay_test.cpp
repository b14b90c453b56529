#include "facenav/scene/overlay.h"

#include <gtest/gtest.h>

#include <cmath>

#include "facenav/scene/colour_scale.h"
#include "facenav/scene/slice_scene.h"

namespace facenav::scene {
namespace {

/// Volume with +value in a ball on the patient's left, -value in one on the right; stored with x to the left.
std::shared_ptr<volume::Volume> twoBlobs(float value) {
  auto map = std::make_shared<volume::Volume>();
  map->grid.size = {81, 81, 81};
  map->grid.mri_from_voxel.linear() = Eigen::Vector3d(-1, 1, 1).asDiagonal();
  map->grid.mri_from_voxel.translation() = Eigen::Vector3d(40, -40, -40);
  for (int k = 0; k < 81; ++k)
    for (int j = 0; j < 81; ++j)
      for (int i = 0; i < 81; ++i) {
        const Eigen::Vector3d p(40 - i, j - 40, k - 40);
        map->voxels.push_back((p - Eigen::Vector3d(-20, 0, 0)).norm() < 8  ? value
                              : (p - Eigen::Vector3d(20, 0, 0)).norm() < 8 ? -value
                                                                           : 0.f);
      }
  return map;
}

volume::SlicePlane axialAt(double z_mm) {
  volume::VoxelGrid grid;
  grid.size = {81, 81, 81};
  grid.mri_from_voxel.translation() = Eigen::Vector3d::Constant(-40);
  return volume::anatomicalPlane(grid, volume::Anatomical::axial, Point<Mri>(0, 0, z_mm), 0.5);
}

std::array<int, 3> colourAt(const RgbImage& image, const volume::SlicePlane& plane, const Point<Mri>& p) {
  const Eigen::Vector3d at = plane.toPixel(p);
  const auto* pixel = image.pixel(int(std::lround(at.x())), int(std::lround(at.y())));
  return {pixel[0], pixel[1], pixel[2]};
}

RgbImage pictureWith(const Overlay& overlay, const volume::SlicePlane& plane) {
  SliceScene scene;
  scene.has_letters = false;
  scene.overlays = {overlay};
  return scene.picture(plane);
}

TEST(Overlay, AStrengthIsDrawnInTheColoursOfItsBarAndInTheMaskAlone) {
  Overlay overlay;
  overlay.map = twoBlobs(4.5f);
  overlay.threshold = 3, overlay.full = 6, overlay.opacity = 1, overlay.is_strength = true;
  auto left_half = std::make_shared<volume::Mask>();
  left_half->grid = overlay.map->grid;
  for (std::size_t v = 0; v < overlay.map->voxels.size(); ++v)
    left_half->voxels.push_back(40 - int(v % 81) < -20);  // x below -20 mm
  overlay.within = left_half;
  const auto plane = axialAt(0);
  const RgbImage image = pictureWith(overlay, plane);
  const auto wanted = sequentialColour(0.5);
  const auto found = colourAt(image, plane, {-24, 0, 0});
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], 255 * wanted[c], 1.5);
  EXPECT_EQ(colourAt(image, plane, {-16, 0, 0}), (std::array<int, 3>{0, 0, 0})) << "outside the mask";
}

TEST(Overlay, MapsShowBothSignsInTheirOwnColoursOnTheirOwnSide) {
  Overlay overlay;
  overlay.map = twoBlobs(5);
  overlay.threshold = 3, overlay.full = 6, overlay.opacity = 1;
  const auto plane = axialAt(0);
  const RgbImage image = pictureWith(overlay, plane);
  const auto left = colourAt(image, plane, {-20, 0, 0}), right = colourAt(image, plane, {20, 0, 0});
  EXPECT_GT(left[0], left[2] + 80) << "positive is warm, on the patient's left";
  EXPECT_GT(right[2], right[0] + 80) << "negative is cold";
  EXPECT_EQ(colourAt(image, plane, {0, 0, 0}), (std::array<int, 3>{0, 0, 0}));
  EXPECT_LT(plane.toPixel({20, 0, 0}).x(), plane.toPixel({-20, 0, 0}).x()) << "radiological";
}

TEST(Overlay, ValuesUnderTheThresholdAreNotShown) {
  Overlay overlay;
  overlay.map = twoBlobs(5);
  overlay.opacity = 1, overlay.threshold = 5.01, overlay.full = 9;
  const auto plane = axialAt(0);
  EXPECT_EQ(colourAt(pictureWith(overlay, plane), plane, {-20, 0, 0}), (std::array<int, 3>{0, 0, 0}));
  EXPECT_EQ(colourAt(pictureWith(overlay, plane), plane, {20, 0, 0}), (std::array<int, 3>{0, 0, 0}));
  overlay.threshold = 4.99;
  EXPECT_GT(colourAt(pictureWith(overlay, plane), plane, {-20, 0, 0})[0], 100);
}

TEST(Overlay, OpacityMixesWithTheMri) {
  Overlay overlay;
  overlay.map = twoBlobs(6);
  overlay.threshold = 3, overlay.full = 6;
  const auto plane = axialAt(0);
  overlay.opacity = 1.0;
  const int whole = colourAt(pictureWith(overlay, plane), plane, {-20, 0, 0})[0];
  overlay.opacity = 0.5;
  EXPECT_NEAR(colourAt(pictureWith(overlay, plane), plane, {-20, 0, 0})[0], 0.5 * whole, 2);
  overlay.opacity = 0.0;
  EXPECT_EQ(colourAt(pictureWith(overlay, plane), plane, {-20, 0, 0})[0], 0);
}

TEST(Overlay, TractsAreDrawnNearThePlaneInTheirDirection) {
  surface::TractLines tracts;
  tracts.points_mm = {{-30, 10, 0.3f}, {30, 10, 0.3f}, {-30, -10, 9}, {30, -10, 9}};
  tracts.ends = {2, 4};
  Overlay overlay;
  overlay.opacity = 1;
  overlay.tracts = std::make_shared<BoxedTracts>(boxed(tracts));
  const auto plane = axialAt(0);
  const RgbImage image = pictureWith(overlay, plane);
  EXPECT_GT(colourAt(image, plane, {5, 10, 0})[0], 180) << "left-right is red";
  EXPECT_LT(colourAt(image, plane, {5, 10, 0})[1], 30);
  EXPECT_EQ(colourAt(image, plane, {5, -10, 0}), (std::array<int, 3>{0, 0, 0})) << "9 mm above the slice";
}

TEST(Overlay, AMeshIsDrawnAsItsCut) {
  auto mesh = std::make_shared<surface::TriangleMesh>();
  mesh->vertices_mm = {{-20, 0, -10}, {-20, 0, 10}, {-20, 30, 0}};
  mesh->triangles = {{0, 1, 2}};
  mesh->normals.assign(3, Eigen::Vector3d::UnitX());
  Overlay overlay;
  overlay.mesh = mesh, overlay.opacity = 1;
  const auto plane = axialAt(0);
  const RgbImage image = pictureWith(overlay, plane);
  EXPECT_GT(colourAt(image, plane, {-20, 15, 0})[1], 180);
  EXPECT_EQ(colourAt(image, plane, {20, 15, 0})[1], 0);
  EXPECT_EQ(colourAt(image, plane, {-20, -5, 0})[1], 0);
}

TEST(Overlay, TheCortexShowsWhatLiesUnderIt) {
  const auto map = twoBlobs(5);
  surface::TriangleMesh surface;
  surface.vertices_mm = {{-31, 0, 0}, {31, 0, 0}, {-34, 0, 0}};
  surface.normals = {{-1, 0, 0}, {1, 0, 0}, {-1, 0, 0}};
  const auto values = valuesUnder(surface, *map);
  EXPECT_FLOAT_EQ(values[0], 5.f);  // the ball ends 3 mm under it
  EXPECT_FLOAT_EQ(values[1], -5.f);
  EXPECT_FLOAT_EQ(values[2], 0.f);  // 6 mm
}

TEST(Overlay, ColoursAreSymmetricInBrightnessAndEndAtFull) {
  const auto same = [](const palette::Rgb& a, const palette::Rgb& b) { return a == b; };
  EXPECT_TRUE(same(mapColour(6, 3, 6), mapColour(60, 3, 6)));
  EXPECT_TRUE(same(mapColour(-6, 3, 6), mapColour(-60, 3, 6)));
  EXPECT_FALSE(same(mapColour(4, 3, 6), mapColour(6, 3, 6)));
  const auto sum = [](const palette::Rgb& c) { return c[0] + c[1] + c[2]; };
  EXPECT_LT(sum(mapColour(3, 3, 6)), sum(mapColour(4.5, 3, 6)));
  EXPECT_LT(sum(mapColour(4.5, 3, 6)), sum(mapColour(6, 3, 6)));
  EXPECT_LT(sum(mapColour(-3, 3, 6)), sum(mapColour(-4.5, 3, 6)));
}

}  // namespace
}  // namespace facenav::scene
