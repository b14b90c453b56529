#include "facenav/scene/coil_slices.h"

#include <gtest/gtest.h>

#include <cmath>

namespace facenav::scene {
namespace {

/// Cube of 161 mm, stored with x to the left as LPS scans are, with the function's values.
template <class ValueAt>
SliceScene cubeOf(ValueAt value_at) {
  auto mri = std::make_shared<volume::Volume>();
  mri->grid.size = {161, 161, 161};
  mri->grid.mri_from_voxel.linear() = Eigen::Vector3d(-1, 1, 1).asDiagonal();
  mri->grid.mri_from_voxel.translation() = Eigen::Vector3d(80, -80, -80);
  for (int k = 0; k < 161; ++k)
    for (int j = 0; j < 161; ++j)
      for (int i = 0; i < 161; ++i)
        mri->voxels.push_back(float(value_at(Eigen::Vector3d(80 - i, j - 80, k - 80))));
  SliceScene scene;
  scene.mri = mri;
  scene.has_letters = false;
  return scene;
}

/// A coil over the left side of the head: z into it, handle backwards and down.
RigidTransform<Mri, Coil> leftCoil() {
  const Eigen::Vector3d z = Eigen::Vector3d(0.6, -0.1, -0.79).normalized();
  const Eigen::Vector3d y =
      (Eigen::Vector3d(0.5, 0.8, 0.1) - z.dot(Eigen::Vector3d(0.5, 0.8, 0.1)) * z).normalized();
  Eigen::Matrix3d axes;
  axes << y.cross(z), y, z;
  return {Eigen::Quaterniond(axes), {-30, 4, 40}};
}

RgbImage pictureOf(const SliceScene& scene, const SlicedCoil& coil, CoilCut cut, int width = 200,
                   int height = 220) {
  return coilSlicePicture(scene, coil, cut, coilPlane(coil.mri_T_coil, cut, width, height));
}

/// Pixel of a point of Coil, by the header's description alone.
Eigen::Vector2i pixelOf(double row_mm, double depth_mm, int width = 200, int height = 220) {
  const double spacing_mm = (kCoilSliceAbove_mm + kCoilSliceDepth_mm) / height;
  return {int(std::lround(0.5 * (width - 1) + row_mm / spacing_mm)),
          int(std::lround((depth_mm + kCoilSliceAbove_mm) / spacing_mm))};
}

TEST(CoilSlices, ShowAGradientAsItLiesUnderTheCoil) {
  const Eigen::Vector3d slope(0.45, 0.3, -0.6);
  const SliceScene scene = cubeOf([&](const Eigen::Vector3d& p) { return 128 + slope.dot(p); });
  SlicedCoil coil{leftCoil(), guidance::figureOfEight(), {}};
  const Eigen::Matrix3d axes = coil.mri_T_coil.rotation();
  const Eigen::Vector3d centre = coil.mri_T_coil.translation_mm();
  int compared = 0;
  for (const CoilCut cut : {CoilCut::along_handle, CoilCut::across_handle}) {
    const RgbImage image = pictureOf(scene, coil, cut);
    const Eigen::Vector3d row = cut == CoilCut::along_handle ? axes.col(1) : Eigen::Vector3d(-axes.col(0));
    for (int u = 20; u < 180; u += 11)
      for (int v = 60; v < 200; v += 11) {
        const double spacing_mm = (kCoilSliceAbove_mm + kCoilSliceDepth_mm) / 220;
        const double row_mm = (u - 99.5) * spacing_mm, depth_mm = v * spacing_mm - kCoilSliceAbove_mm;
        const Eigen::Vector3d p = centre + row_mm * row + depth_mm * axes.col(2);
        if (std::abs(row_mm) < 3 || p.cwiseAbs().maxCoeff() > 78) continue;  // the beam; the cube's end
        EXPECT_NEAR(image.pixel(u, v)[0] + 0.5, 128 + slope.dot(p), 0.6) << u << " " << v;  // whole greys
        ++compared;
      }
  }
  EXPECT_GT(compared, 150);
}

/// Mean brightness of the left and the right half under the contact face.
std::pair<double, double> halves(const RgbImage& image) {
  double sum[2] = {0, 0};
  for (int v = 60; v < image.height_px; ++v)
    for (int u = 0; u < image.width_px; ++u) sum[u >= image.width_px / 2] += image.pixel(u, v)[0];
  return {sum[0], sum[1]};
}

TEST(CoilSlices, ShowABallOnItsOwnSide) {
  const SlicedCoil coil{leftCoil(), guidance::figureOfEight(), {}};
  const auto ballAt = [&](double x, double y) {
    const Eigen::Vector3d centre = (coil.mri_T_coil * Point<Coil>(x, y, 35)).mm;
    return cubeOf([centre](const Eigen::Vector3d& p) { return (p - centre).norm() < 6 ? 200 : 0; });
  };
  const auto [ahead_left, ahead_right] = halves(pictureOf(ballAt(0, 20), coil, CoilCut::along_handle));
  EXPECT_GT(ahead_right - ahead_left, 1e4) << "the handle's prolongation is on the right";
  const auto [left_wing_left, left_wing_right] =
      halves(pictureOf(ballAt(20, 0), coil, CoilCut::across_handle));
  EXPECT_GT(left_wing_left - left_wing_right, 1e4) << "the coil's +x is on the left, as behind the handle";
  const auto [off_left, off_right] = halves(pictureOf(ballAt(20, 0), coil, CoilCut::along_handle));
  EXPECT_NEAR(off_left, off_right, 2e3) << "a ball beside the slice does not show";
}

TEST(CoilSlices, PatientsSidesAreNamedByTheVolumesTruth) {
  // Bright on the patient's left only: the bright side of the slice must have the letter L.
  const SliceScene scene = cubeOf([](const Eigen::Vector3d& p) { return p.x() < 0 ? 200 : 0; });
  for (const double handle_deg : {0.0, 90.0, 180.0, 270.0}) {
    const double a = handle_deg * M_PI / 180;
    Eigen::Matrix3d axes;
    const Eigen::Vector3d z(0, 0, -1), y(std::sin(a), std::cos(a), 0);
    axes << y.cross(z), y, z;
    const SlicedCoil coil{{Eigen::Quaterniond(axes), {0, 0, 60}}, guidance::figureOfEight(), {}};
    for (const CoilCut cut : {CoilCut::along_handle, CoilCut::across_handle}) {
      const auto plane = coilPlane(coil.mri_T_coil, cut, 200, 220);
      const std::string right = sideLetters(plane.right);
      if (right != "L" && right != "R") continue;
      const auto [bright_left, bright_right] = halves(coilSlicePicture(scene, coil, cut, plane));
      EXPECT_EQ(bright_right > bright_left, right == "L") << handle_deg;
    }
  }
}

TEST(CoilSlices, ObliqueDirectionsHaveTwoLetters) {
  EXPECT_EQ(sideLetters(Direction<Mri>({-1, 0.1, 0})), "L");
  EXPECT_EQ(sideLetters(Direction<Mri>({-1, 0.9, 0})), "LA");
  EXPECT_EQ(sideLetters(Direction<Mri>({0.5, 0.1, -0.9})), "IR");
}

TEST(CoilSlices, TheErrorIsDrawnToScaleAndOnlyWhenKnown) {
  SliceScene scene = cubeOf([](const Eigen::Vector3d&) { return 0; });
  SlicedCoil coil{leftCoil(), guidance::figureOfEight(), {}};
  guidance::Target target;
  target.name = scene.active_target = "M1";
  target.mri_T_target = coil.mri_T_coil.reframe<Mri, frames::Target>();
  target.scalp_point = coil.mri_T_coil * Point<Coil>(0, 0, 0);
  target.cortex_point = coil.mri_T_coil * Point<Coil>(0, 0, 30);
  scene.targets = {target};
  const auto whiteAt = [&](double row_mm, double depth_mm) {
    const RgbImage image = pictureOf(scene, coil, CoilCut::across_handle);
    const auto at = pixelOf(row_mm, depth_mm);
    return int(image.pixel(at.x(), at.y())[0]);
  };
  EXPECT_LT(whiteAt(8, 30), 20);
  coil.bound95_mm = 8.0;
  EXPECT_GT(whiteAt(8, 30), 120) << "ring of 8 mm round the beam at the cortex point's depth";
  EXPECT_GT(whiteAt(-8, 30), 120);
  EXPECT_LT(whiteAt(12, 30), 20);
  coil.bound95_mm = 12.0;
  EXPECT_GT(whiteAt(12, 30), 120);
}

TEST(CoilSlices, PlateAndBeamLieWhereTheCoilIs) {
  const SliceScene scene = cubeOf([](const Eigen::Vector3d&) { return 0; });
  SlicedCoil coil{leftCoil(), {}, {}};
  coil.plate.outline_mm = {{-40, -20}, {25, -20}, {25, 30}, {-40, 30}};
  const auto blueAt = [&](CoilCut cut, double row_mm, double depth_mm) {
    const RgbImage image = pictureOf(scene, coil, cut);
    const auto at = pixelOf(row_mm, depth_mm);
    return int(image.pixel(at.x(), at.y())[2]);
  };
  EXPECT_GT(blueAt(CoilCut::across_handle, 35, 0), 150);  // -x is on the right
  EXPECT_LT(blueAt(CoilCut::across_handle, -35, 0), 20);
  EXPECT_GT(blueAt(CoilCut::along_handle, 27, 0), 150);
  EXPECT_LT(blueAt(CoilCut::along_handle, 35, 0), 20);
  EXPECT_GT(blueAt(CoilCut::along_handle, 0, 65), 150);  // the beam
  EXPECT_LT(blueAt(CoilCut::along_handle, 0, -8), 20);   // it starts at the contact face
}

TEST(CoilSlices, AFarCrosshairIsNotDrawn) {
  SliceScene scene = cubeOf([](const Eigen::Vector3d&) { return 0; });
  const SlicedCoil coil{leftCoil(), guidance::figureOfEight(), {}};
  const auto sumBlue = [&] {
    const RgbImage image = pictureOf(scene, coil, CoilCut::along_handle);
    long sum = 0;
    for (int u = 0; u < image.width_px; ++u) sum += image.pixel(u, 140)[2];
    return sum;
  };
  const long without = sumBlue();
  const auto plane = coilPlane(coil.mri_T_coil, CoilCut::along_handle, 200, 220);
  const Point<Mri> on = plane.toMri(150, 140);
  scene.crosshair = Point<Mri>(on.mm + 5.0 * plane.right.v.cross(plane.down.v));
  EXPECT_EQ(sumBlue(), without);
  scene.crosshair = on;
  EXPECT_GT(sumBlue(), without + 5000);
}

TEST(CoilSlices, BeamPassesAPointAtDepthAndDistance) {
  const auto coil = leftCoil();
  const auto passing = beamPassing(coil, coil * Point<Coil>(3, 4, 28));
  EXPECT_NEAR(passing.depth_mm, 28, 1e-9);
  EXPECT_NEAR(passing.miss_mm, 5, 1e-9);
}

}  // namespace
}  // namespace facenav::scene
