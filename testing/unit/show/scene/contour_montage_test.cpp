#include "facenav/scene/contour_montage.h"

#include <gtest/gtest.h>

namespace facenav::scene {
namespace {

/// A bright ball of 30 mm about (10, -5, 20) in 100 mm of air, and its mask.
struct Ball {
  std::shared_ptr<volume::Volume> mri = std::make_shared<volume::Volume>();
  std::shared_ptr<volume::Mask> mask = std::make_shared<volume::Mask>();
  Eigen::Vector3d centre_mm{10, -5, 20};

  Ball() {
    mri->grid.size = {50, 50, 50};
    mri->grid.mri_from_voxel.linear() *= 2.0;
    mri->grid.mri_from_voxel.translation() = Eigen::Vector3d::Constant(-50.0);
    mask->grid = mri->grid;
    for (int k = 0; k < 50; ++k)
      for (int j = 0; j < 50; ++j)
        for (int i = 0; i < 50; ++i) {
          const bool is_inside = (mri->grid.toMri(Eigen::Vector3d(i, j, k)).mm - centre_mm).norm() < 30;
          mri->voxels.push_back(is_inside ? 100.f : 0.f);
          mask->voxels.push_back(is_inside);
        }
  }
};

TEST(ContourMontage, CoversTheContentFromEndToEndInThreeOrientations) {
  const Ball ball;
  SliceScene scene;
  scene.mri = ball.mri;
  scene.contours = {{ball.mask, {0.0, 1.0, 0.0}}};
  const MontageOptions options{6, 64, 2, 1, 1};
  const auto montage = contourMontage(scene, *ball.mask, options);
  ASSERT_EQ(montage.tiles.size(), 24u);
  double low[3] = {1e9, 1e9, 1e9}, high[3] = {-1e9, -1e9, -1e9};
  for (const auto& tile : montage.tiles) {
    const int axis = tile.orientation == volume::Anatomical::axial     ? 2
                     : tile.orientation == volume::Anatomical::coronal ? 1
                                                                       : 0;
    low[axis] = std::min(low[axis], tile.centre.mm[axis]);
    high[axis] = std::max(high[axis], tile.centre.mm[axis]);
    // The ball's middle is bright in every tile, and every tile has some contour.
    const auto* middle = montage.picture.pixel(tile.u + 32, tile.v + 32);
    EXPECT_GT(int(middle[0]), 60);
    int green = 0;
    for (int v = 0; v < 64; ++v)
      for (int u = 0; u < 64; ++u) {
        const auto* p = montage.picture.pixel(tile.u + u, tile.v + v);
        green += p[1] > p[0] + 60 && p[1] > p[2] + 60;
      }
    EXPECT_GT(green, 10);
  }
  for (int axis = 0; axis < 3; ++axis) {  // first and last slice: half a step inside the ball's ends
    EXPECT_NEAR(0.5 * (low[axis] + high[axis]), ball.centre_mm[axis], 1.5);
    EXPECT_GT(high[axis] - low[axis], 45.0);
    EXPECT_LT(high[axis] - low[axis], 60.0);
  }
  EXPECT_GT(montage.tiles.front().centre.mm.z(), montage.tiles[11].centre.mm.z());  // from the top
}

TEST(ContourMontage, TheSheetFillsTheAreaItIsGiven) {
  for (const auto& [width, height] : {std::pair(980, 760), std::pair(1500, 900), std::pair(760, 900)}) {
    const auto options = sheetFor(width, height);
    const int rows = options.axial_rows + options.coronal_rows + options.sagittal_rows;
    const int used_width = options.columns * (options.tile_px + 3),
              used_height = rows * (options.tile_px + 3);
    EXPECT_LE(used_width, width);
    EXPECT_LE(used_height, height);
    EXPECT_GT(used_width * used_height, 0.90 * width * height) << width << " x " << height;
    EXPECT_GE(rows, 5);
    EXPECT_GE(options.sagittal_rows, 1);
  }
}

TEST(ContourMontage, IsEmptyForAnEmptyMask) {
  const Ball ball;
  SliceScene scene;
  scene.mri = ball.mri;
  volume::Mask none = *ball.mask;
  none.voxels.assign(none.voxels.size(), 0);
  EXPECT_TRUE(contourMontage(scene, none, {}).tiles.empty());
}

}  // namespace
}  // namespace facenav::scene
