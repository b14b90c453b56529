#include "facenav/scene/cortex_picture.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "facenav/scene/display.h"
#include "facenav/scene/navigation_scene.h"
#include "support/ball_mesh.h"

namespace facenav::scene {
namespace {

constexpr double kRadius_mm = 60.0;

/// A ball of 60 mm, 3 mm outside its model; its MRI values increase by 10 per mm from the centre outwards.
struct CortexBall {
  volume::Volume mri;
  volume::Mask brain;
  CortexBall() {
    auto& grid = mri.grid;
    grid.size = {50, 50, 50};
    grid.mri_from_voxel.linear() *= 3.0;
    grid.mri_from_voxel.translation() = Eigen::Vector3d::Constant(-73.5);
    for (int k = 0; k < 50; ++k)
      for (int j = 0; j < 50; ++j)
        for (int i = 0; i < 50; ++i) {
          const double r = grid.toMri(Eigen::Vector3d(i, j, k)).mm.norm();
          mri.voxels.push_back(float(10.0 * r));
          brain.voxels.push_back(r < kRadius_mm);
        }
    brain.grid = grid;
  }
  CortexPicture picture() const {
    TaskMonitor monitor;
    surface::DetailedCortex cortex;
    cortex.mesh = testing::ballMesh(kRadius_mm, 60, 80);
    cortex.distance_mm.assign(cortex.mesh.vertices_mm.size(), 3.2f);
    return makeCortexPicture(mri, brain, cortex, monitor);
  }
};

TEST(CortexPicture, TheColourScaleEndsAWholeMillimetreBeyondTheDistances) {
  const auto picture = CortexBall().picture();
  EXPECT_NEAR(picture.distance.median_mm, 3.2, 1e-6);
  EXPECT_EQ(picture.full_mm, 4.0);
  EXPECT_EQ(distanceColour(9, 4), distanceColour(4, 4));
  EXPECT_GT(distanceColour(4, 4)[0], distanceColour(4, 4)[2]);    // orange
  EXPECT_LT(distanceColour(-4, 4)[0], distanceColour(-4, 4)[2]);  // blue
}

TEST(CortexPicture, TheCoarseSurfaceIsTheSameBallWithFewerTriangles) {
  const auto picture = CortexBall().picture();
  EXPECT_LT(picture.coarse_mesh.triangles.size(), picture.cortex.mesh.triangles.size());
  EXPECT_GT(picture.coarse_mesh.triangles.size(), 500u);
  for (const auto& v : picture.coarse_mesh.vertices_mm) ASSERT_NEAR(v.norm(), kRadius_mm, 1.0);
}

TEST(CortexPicture, IsDrawnAtThePeelDepthAndByDistance) {
  if (!hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const CortexBall ball;
  TaskMonitor monitor;
  NavigationScene scene;
  scene.setScalp(testing::ballMesh(90, 30, 40));
  SceneLayers only_brain;
  only_brain.scalp = only_brain.coil = only_brain.targets = false;
  scene.setLayers(only_brain);
  scene.setBrain(surface::buildBrainModel(ball.mri, ball.brain, {}, monitor));
  scene.setCortex(std::make_shared<CortexPicture>(ball.picture()));
  const auto middle = [&] {
    const RgbImage image = scene.render(160, 160);
    const std::uint8_t* p = &image.rgb[3 * (80 * 160 + 80)];
    return std::array<int, 3>{p[0], p[1], p[2]};
  };
  scene.setBrainLook(BrainLook::cortex);
  scene.setPeelDepth(2);
  const auto bright = middle();
  scene.setPeelDepth(35);
  const auto dark = middle();
  EXPECT_GT(bright[1], dark[1] + 40);  // darker towards the middle
  scene.setBrainLook(BrainLook::distance);
  EXPECT_GT(middle()[0], middle()[2] + 30);  // outside the model: orange
  scene.setBrainLook(BrainLook::cortex);
  EXPECT_EQ(middle(), dark);
  scene.setQuick(true);
  EXPECT_NEAR(middle()[1], dark[1], 20);
  scene.setQuick(false);
  const auto pick = scene.pick(80, 80);
  ASSERT_TRUE(pick);
  EXPECT_TRUE(pick->is_brain);
  EXPECT_NEAR(pick->point.mm.norm(), kRadius_mm, 1.5);
}

}  // namespace
}  // namespace facenav::scene
