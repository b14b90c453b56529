#include "facenav/scene/navigation_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "facenav/scene/bulls_eye.h"
#include "facenav/scene/display.h"
#include "facenav/scene/palette.h"
#include "support/ball_mesh.h"

#define FACENAV_NEEDS_DISPLAY() \
  if (!hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run"

namespace facenav::scene {
namespace {

guidance::Target topTarget() {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();  // z down into the head, y anterior, x = y cross z = left
  m.block<3, 3>(0, 0) << -1, 0, 0, 0, 1, 0, 0, 0, -1;
  m(2, 3) = 100.0;
  guidance::Target target;
  target.name = "vertex";
  target.mri_T_target = RigidTransform<Mri, Target>::fromMatrix(m);
  target.cortex_point = Point<Mri>(0, 0, 80);
  target.scalp_point = Point<Mri>(0, 0, 100);
  return target;
}

/// Share of pixels closer to the copper of the coil's windings than to grey.
double copperShare(const RgbImage& image) {
  int n = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) n += int(image.rgb[i]) - int(image.rgb[i + 2]) > 45;
  return n / (image.rgb.size() / 3.0);
}

/// Mean difference red - blue (grey levels): > 0 for skin, copper and orange, 0 for grey and the background.
double warmth(const RgbImage& image) {
  double sum = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3)
    sum += std::max(0, int(image.rgb[i]) - int(image.rgb[i + 2]));
  return sum / (image.rgb.size() / 3.0);
}

class NavigationSceneTest : public ::testing::Test {
 protected:
  void prepare() {
    scene_ = std::make_unique<NavigationScene>();
    scene_->setScalp(testing::ballMesh(100, 40, 60));
    scene_->setTargets({topTarget()}, "vertex");
    scene_->setView(ViewPreset::target);
  }
  /// Pose of a camera 600 mm in front of the face, looking along -y of Mri; Camera x = patient's left.
  static RigidTransform<Camera, Mri> cameraPose() {
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    m.block<3, 3>(0, 0) << -1, 0, 0, 0, 0, -1, 0, -1, 0;
    m(2, 3) = 600;
    return RigidTransform<Camera, Mri>::fromMatrix(m);
  }
  static RigidTransform<Camera, Coil> coilAtTarget() {
    return cameraPose() * topTarget().mri_T_target.reframe<Mri, Coil>();  // the wanted pose of Coil
  }
  std::unique_ptr<NavigationScene> scene_;
};

TEST_F(NavigationSceneTest, ShowsTheCoilOnlyWhileHeadAndCoilAreTracked) {
  FACENAV_NEEDS_DISPLAY();
  prepare();
  EXPECT_FALSE(scene_->showsCoil());
  scene_->setHeadPose({cameraPose(), 0.9});
  scene_->setCoilPose({coilAtTarget(), 0.9});
  EXPECT_TRUE(scene_->showsCoil());
  const RgbImage tracked = scene_->render(320, 240);
  const double with_coil = copperShare(tracked);
  scene_->setHeadPose(Lost{LostReason::no_face});
  EXPECT_FALSE(scene_->showsCoil());
  const RgbImage lost = scene_->render(320, 240);
  EXPECT_GT(with_coil, 0.005);
  EXPECT_LT(copperShare(lost), 0.0005);  // coil hidden, target ring grey
  EXPECT_GT(warmth(tracked), 2.0);
  EXPECT_LT(warmth(lost), 0.2);  // skin grey
  scene_->setHeadPose({cameraPose(), 0.9});
  scene_->setCoilPose(Lost{LostReason::no_marker});
  EXPECT_FALSE(scene_->showsCoil());
}

TEST_F(NavigationSceneTest, HeadStandsStillWhenHeadAndCoilMoveTogether) {
  FACENAV_NEEDS_DISPLAY();
  prepare();
  scene_->setHeadPose({cameraPose(), 0.9});
  scene_->setCoilPose({coilAtTarget(), 0.9});
  const RgbImage before = scene_->render(200, 160);
  const RigidTransform<Camera, Camera> motion(
      Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 0.5).normalized())), {30, -20, 40});
  scene_->setHeadPose({motion * cameraPose(), 0.9});
  scene_->setCoilPose({motion * coilAtTarget(), 0.9});
  const RgbImage after = scene_->render(200, 160);
  double difference = 0;
  for (std::size_t i = 0; i < before.rgb.size(); ++i)
    difference += std::abs(int(before.rgb[i]) - int(after.rgb[i]));
  EXPECT_LT(difference / before.rgb.size(), 0.05);  // grey levels; only rounding of the matrices
}

TEST_F(NavigationSceneTest, FrontViewPutsThePatientsLeftOnTheRight) {
  FACENAV_NEEDS_DISPLAY();
  prepare();
  guidance::Target left = topTarget();
  left.cortex_point = Point<Mri>(-60, 0, 30);
  left.mri_T_target = RigidTransform<Mri, Target>(Eigen::Quaterniond::Identity(), {-80, 0, 40});
  scene_->setTargets({left}, "vertex");
  scene_->setView(ViewPreset::front);
  SceneLayers layers;
  layers.scalp = false;
  scene_->setLayers(layers);
  const RgbImage image = scene_->render(300, 240);
  double sum_u = 0, n = 0;
  for (int v = 0; v < 180; ++v)  // above the head icon
    for (int u = 0; u < 300; ++u)
      if (image.pixel(u, v)[0] - image.pixel(u, v)[2] > 60) sum_u += u, ++n;
  ASSERT_GT(n, 10);
  EXPECT_GT(sum_u / n, 190.0);
}

TEST_F(NavigationSceneTest, PickReturnsThePointUnderTheMouseInMri) {
  FACENAV_NEEDS_DISPLAY();
  prepare();
  scene_->setView(ViewPreset::front);
  scene_->render(300, 300);
  const auto pick = scene_->pick(150, 150);
  ASSERT_TRUE(pick.has_value());
  EXPECT_FALSE(pick->is_brain);
  EXPECT_NEAR(pick->point.mm.norm(), 100.0, 0.5);
  EXPECT_GT(pick->point.mm.y(), 98.0);
  EXPECT_FALSE(scene_->pick(2, 298).has_value());
}

TEST(BullsEye, IsWholeInANarrowPictureToo) {
  if (!hasDisplay()) GTEST_SKIP() << "no X display here";
  BullsEye bulls_eye;
  for (const auto& [width, height] : {std::pair(300, 300), std::pair(400, 200), std::pair(150, 400)}) {
    const RgbImage image = bulls_eye.render(width, height);
    const auto shown = [&](int u, int v) {
      return std::vector<int>(image.pixel(u, v), image.pixel(u, v) + 3);
    };
    const auto panel = shown(0, 0);
    for (int v = 0; v < height; ++v) {
      EXPECT_EQ(shown(2, v), panel) << width << " x " << height << ", line " << v;
      EXPECT_EQ(shown(width - 3, v), panel);
    }
    EXPECT_NE(shown(width / 2, height / 2), panel);
  }
}

}  // namespace
}  // namespace facenav::scene
