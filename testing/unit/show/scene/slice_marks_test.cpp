// Window and level, crosshair, targets and letters of a slice picture; the strokes they are painted with.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "facenav/scene/slice_scene.h"
#include "paint.h"

namespace facenav::scene {
namespace {

using volume::Anatomical;

/// Volume of 101 x 101 x 101 mm about the origin; the value is 10 x + 1000.
std::shared_ptr<volume::Volume> ramp() {
  auto mri = std::make_shared<volume::Volume>();
  mri->grid.size = {101, 101, 101};
  mri->grid.mri_from_voxel.translation() = Eigen::Vector3d::Constant(-50.0);
  for (int n = 0; n < 101 * 101 * 101; ++n) mri->voxels.push_back(10.f * float(n % 101 - 50) + 1000.f);
  return mri;
}

volume::SlicePlane plane(Anatomical orientation, const Point<Mri>& through, double spacing_mm = 1.0) {
  volume::VoxelGrid grid;
  grid.size = {101, 101, 101};
  grid.mri_from_voxel.translation() = Eigen::Vector3d::Constant(-50.0);
  return volume::anatomicalPlane(grid, orientation, through, spacing_mm);
}

const std::uint8_t* at(const RgbImage& image, const volume::SlicePlane& plane, const Point<Mri>& p) {
  const Eigen::Vector3d px = plane.toPixel(p);
  return image.pixel(int(std::lround(px.x())), int(std::lround(px.y())));
}

SliceScene plainScene() {
  SliceScene scene;
  scene.has_letters = false;
  return scene;
}

TEST(SliceWindow, IsLinearBetweenBlackAndWhiteAndEndsThere) {
  SliceScene scene = plainScene();
  scene.mri = ramp();
  scene.black = 900;
  scene.white = 1100;  // x = -10 .. 10
  const auto axial = plane(Anatomical::axial, {0, 0, 0});
  const RgbImage image = scene.picture(axial);
  const auto grey = [&](double x_mm) { return int(at(image, axial, {x_mm, 3, 0})[1]); };
  EXPECT_EQ(grey(-10), 0);
  EXPECT_EQ(grey(-40), 0);
  EXPECT_NEAR(grey(10), 255, 1);  // the pixel nearest to 10 mm
  EXPECT_EQ(grey(12), 255);
  EXPECT_EQ(grey(40), 255);
  EXPECT_NEAR(grey(0), 127.5, 1);
  EXPECT_NEAR(grey(5), 0.75 * 255, 1);
}

TEST(SliceWindow, PicturesOfTheMriAreGrey) {
  SliceScene scene = plainScene();
  scene.mri = ramp();
  setUsualWindow(scene);
  const RgbImage image = scene.picture(plane(Anatomical::coronal, {0, 0, 0}));
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    ASSERT_EQ(image.rgb[i], image.rgb[i + 1]);
    ASSERT_EQ(image.rgb[i], image.rgb[i + 2]);
  }
}

TEST(SliceWindow, WithoutWidthIsAStepAndNoDivisionByZero) {
  SliceScene scene = plainScene();
  scene.mri = ramp();
  scene.black = scene.white = 1000;
  const auto axial = plane(Anatomical::axial, {0, 0, 0});
  const RgbImage image = scene.picture(axial);
  EXPECT_EQ(int(at(image, axial, {-5, 0, 0})[0]), 0);
  EXPECT_EQ(int(at(image, axial, {5, 0, 0})[0]), 255);
}

TEST(SliceWindow, TheUsualOneLeavesHalfAPercentAtEitherEnd) {
  SliceScene scene;
  scene.mri = ramp();  // values uniform over 500 .. 1500
  setUsualWindow(scene);
  EXPECT_NEAR(scene.black, 505, 10);
  EXPECT_NEAR(scene.white, 1495, 10);
  auto flat = std::make_shared<volume::Volume>(*scene.mri);
  std::fill(flat->voxels.begin(), flat->voxels.end(), 7.f);
  scene.mri = flat;
  setUsualWindow(scene);
  EXPECT_GT(scene.white, scene.black) << "a flat volume, too, has a window";
}

TEST(SliceCrosshair, HasTheValueOfItsVoxelAndNoneOutside) {
  SliceScene scene;
  EXPECT_FALSE(scene.valueAtCrosshair());
  scene.mri = ramp();
  EXPECT_FALSE(scene.valueAtCrosshair()) << "no crosshair";
  scene.crosshair = Point<Mri>(12.2, -7, 33);
  EXPECT_EQ(scene.valueAtCrosshair().value(), 1120.f);
  scene.crosshair = Point<Mri>(-12.4, -7, 33);
  EXPECT_EQ(scene.valueAtCrosshair().value(), 880.f);
  scene.crosshair = Point<Mri>(51, 0, 0);
  EXPECT_FALSE(scene.valueAtCrosshair());
}

TEST(SliceCrosshair, CrossesAtItsPlaceAndLeavesItOpen) {
  SliceScene scene = plainScene();
  for (const auto orientation : {Anatomical::axial, Anatomical::coronal, Anatomical::sagittal}) {
    const Point<Mri> here(-20, 15, 10);
    scene.crosshair = here;
    const auto slice = plane(orientation, here);
    const RgbImage image = scene.picture(slice);
    const Eigen::Vector3d px = slice.toPixel(here);
    const int u = int(std::lround(px.x())), v = int(std::lround(px.y()));
    EXPECT_EQ(int(image.pixel(u, v)[2]), 0) << "what lies under it stays visible";
    EXPECT_EQ(int(image.pixel(u + 5, v)[2]), 0);
    for (const int away : {-12, 12}) {
      EXPECT_GT(int(image.pixel(u + away, v)[2]), 120);
      EXPECT_GT(int(image.pixel(u, v + away)[2]), 120);
      EXPECT_EQ(int(image.pixel(u + away, v + away)[2]), 0);
    }
  }
}

guidance::Target target(const std::string& name, const Point<Mri>& cortex, const Point<Mri>& scalp) {
  guidance::Target target;
  target.name = name;
  target.cortex_point = cortex;
  target.scalp_point = scalp;
  return target;
}

TEST(SliceTargets, AreCircledOnSlicesNearTheirCortexPointOnly) {
  SliceScene scene = plainScene();
  const Point<Mri> cortex(-20, 5, 10);
  scene.targets = {target("M1", cortex, {-30, 5, 20})};
  scene.active_target = "M1";
  const auto ring = [&](double z_mm) {
    const auto slice = plane(Anatomical::axial, {0, 0, z_mm}, 0.5);
    const RgbImage image = scene.picture(slice);
    return int(at(image, slice, {cortex.mm.x(), cortex.mm.y() + 4.0, z_mm})[0]);  // radius 4 mm
  };
  EXPECT_GT(ring(10), 200);
  EXPECT_GT(ring(13), 200);
  EXPECT_EQ(ring(15), 0);
  EXPECT_EQ(ring(-30), 0);
}

TEST(SliceTargets, LieOnTheirSideAndTheActiveOneIsOrange) {
  SliceScene scene = plainScene();
  scene.targets = {target("left", {-25, 0, 0}, {-40, 0, 0}), target("right", {25, 0, 0}, {40, 0, 0})};
  scene.active_target = "left";
  const auto axial = plane(Anatomical::axial, {0, 0, 0});
  const RgbImage image = scene.picture(axial);
  const auto warmth = [&](double x_mm) {  // middle of the line from cortex to scalp
    const auto* p = at(image, axial, {x_mm, 0, 0});
    return int(p[0]) - int(p[2]);
  };
  EXPECT_GT(warmth(-33), 80);
  EXPECT_LT(std::abs(warmth(33)), 40) << "grey";
  EXPECT_GT(int(at(image, axial, {33, 0, 0})[1]), 80);
  EXPECT_GT(axial.toPixel(Point<Mri>(-33, 0, 0)).x(), axial.toPixel(Point<Mri>(33, 0, 0)).x())
      << "the patient's left on the picture's right";
}

/// Letter that is painted at a place, one of six.
char letterAt(const RgbImage& image, int u, int v, double height_px) {
  const int reach = int(0.7 * height_px);
  char best = '?';
  double least = std::numeric_limits<double>::infinity();
  for (const char candidate : {'R', 'L', 'A', 'P', 'S', 'I'}) {
    RgbImage drawn(2 * reach + 1, 2 * reach + 1);
    letter(drawn, candidate, {double(reach), double(reach)}, height_px, palette::kText);
    double difference = 0;
    for (int y = 0; y <= 2 * reach; ++y)
      for (int x = 0; x <= 2 * reach; ++x)
        difference += std::abs(image.pixel(u + x - reach, v + y - reach)[0] - drawn.pixel(x, y)[0]);
    if (difference < least) least = difference, best = candidate;
  }
  return best;
}

TEST(SliceLetters, NameLeftRightTopAndBottomOfEachSlice) {
  const SliceScene scene;
  const auto letters = [&](Anatomical orientation) {
    const auto slice = plane(orientation, {0, 0, 0}, 100.0 / 400);  // 401 x 401 px: letters of 18 px
    const RgbImage image = scene.picture(slice);
    const int middle = 200, far = 401 - 18;
    return std::string{letterAt(image, 18, middle, 18), letterAt(image, far, middle, 18),
                       letterAt(image, middle, 18, 18), letterAt(image, middle, far, 18)};
  };
  EXPECT_EQ(letters(Anatomical::axial), "RLAP");
  EXPECT_EQ(letters(Anatomical::coronal), "RLSI");
  EXPECT_EQ(letters(Anatomical::sagittal), "APSI");
}

TEST(SliceLetters, TellWhereAMarkedPlaceLies) {
  SliceScene scene;
  scene.points.points_mm = {{30, 0, 0}};  // the patient's right
  const auto slice = plane(Anatomical::axial, {0, 0, 0}, 100.0 / 400);
  const RgbImage image = scene.picture(slice);
  const double u = slice.toPixel(Point<Mri>(30, 0, 0)).x();
  EXPECT_GT(int(at(image, slice, {30, 0, 0})[0]), 150);
  EXPECT_LT(u, 200) << "on the side of the letter R";
  EXPECT_EQ(letterAt(image, 18, 200, 18), 'R');
}

TEST(Paint, BlendsByItsOpacityAndIgnoresWhatIsOutside) {
  RgbImage image(3, 2);
  blend(image, 1, 1, {1.0, 0.5, 0.0}, 0.5);
  EXPECT_EQ(int(image.pixel(1, 1)[0]), 128);
  EXPECT_EQ(int(image.pixel(1, 1)[1]), 64);
  EXPECT_EQ(int(image.pixel(1, 1)[2]), 0);
  const auto before = image.rgb;
  blend(image, -1, 0, {1, 1, 1}, 1.0);
  blend(image, 3, 0, {1, 1, 1}, 1.0);
  blend(image, 0, 2, {1, 1, 1}, 1.0);
  EXPECT_EQ(image.rgb, before);
}

TEST(Paint, ALineHasItsWidthAndACircleItsRadius) {
  RgbImage image(101, 101);
  line(image, {20, 50}, {80, 50}, {1, 1, 1}, 5.0, 1.0);
  double ink = 0;
  for (int v = 0; v < 101; ++v) ink += image.pixel(50, v)[0] / 255.0;
  EXPECT_NEAR(ink, 5.0, 0.05);
  EXPECT_EQ(int(image.pixel(10, 50)[0]), 0);
  RgbImage round(101, 101);
  circle(round, {50, 50}, 30, {1, 1, 1}, 2.0, 1.0);
  for (const double angle : {0.0, 0.7, 2.0, 4.4}) {
    double sum = 0, weight = 0;
    for (double r = 20; r < 40; r += 0.25) {
      const double value = round.pixel(int(std::lround(50 + r * std::cos(angle))),
                                       int(std::lround(50 + r * std::sin(angle))))[0];
      sum += value * r, weight += value;
    }
    EXPECT_NEAR(sum / weight, 30.0, 0.6) << angle;
  }
}

TEST(Paint, ToleratesStrokesThatLeaveThePictureOrAreNotFinite) {
  RgbImage image(20, 20);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  line(image, {nan, 3}, {5, 5}, {1, 1, 1}, 2.0, 1.0);
  circle(image, {nan, nan}, 3, {1, 1, 1}, 2.0, 1.0);
  letter(image, '?', {10, 10}, 9, {1, 1, 1});
  EXPECT_EQ(*std::max_element(image.rgb.begin(), image.rgb.end()), 0);
  line(image, {-50, 10}, {70, 10}, {1, 1, 1}, 2.0, 1.0);
  EXPECT_GT(int(image.pixel(0, 10)[0]), 200);
  EXPECT_GT(int(image.pixel(19, 10)[0]), 200);
}

}  // namespace
}  // namespace facenav::scene
