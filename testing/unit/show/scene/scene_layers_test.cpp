// Content of the 3-D scene with positions and colours: targets, coil, beam, ghost, slices, layers on and off.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>

#include "facenav/scene/display.h"
#include "facenav/scene/navigation_scene.h"
#include "support/ball_mesh.h"
#include "support/matchers.h"

namespace facenav::scene {
namespace {

using testing::EigenNear;
constexpr int kSide_px = 300;

bool isOrange(const std::uint8_t* p) { return p[0] - p[2] > 60; }
bool isBlue(const std::uint8_t* p) { return p[2] - p[0] > 60; }

/// Number and mean place (x right, y up, -1..1) of the pixels that `is` selects, without the head icon's
/// corner.
struct Spot {
  int pixels = 0;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
};
Spot find(const RgbImage& image, const std::function<bool(const std::uint8_t*)>& is) {
  Spot spot;
  for (int v = 0; v < image.height_px; ++v)
    for (int u = 0; u < image.width_px; ++u) {
      if (u < image.width_px / 4 && v > 3 * image.height_px / 4) continue;
      if (!is(image.pixel(u, v))) continue;
      ++spot.pixels;
      spot.place +=
          Eigen::Vector2d(2.0 * (u + 0.5) / image.width_px - 1, 1 - 2.0 * (v + 0.5) / image.height_px);
    }
  if (spot.pixels) spot.place /= spot.pixels;
  return spot;
}

/// A target on the forehead side: z into the head along -y of Mri.
guidance::Target frontTarget(const std::string& name, double x_mm, double z_mm) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.block<3, 3>(0, 0) << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  m.block<3, 1>(0, 3) << x_mm, 80, z_mm;
  guidance::Target target;
  target.name = name;
  target.mri_T_target = RigidTransform<Mri, Target>::fromMatrix(m);
  target.cortex_point = Point<Mri>(x_mm, 60, z_mm);
  target.scalp_point = Point<Mri>(x_mm, 80, z_mm);
  return target;
}

class SceneLayersTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
    scene_ = std::make_unique<NavigationScene>();
    scene_->setScalp(testing::ballMesh(100, 40, 60));
    scene_->setView(ViewPreset::front);
    show([](SceneLayers&) {});
  }
  /// Shows the layers without scalp, since skin has a warm colour, too.
  void show(const std::function<void(SceneLayers&)>& change) {
    SceneLayers layers;
    layers.scalp = false;
    change(layers);
    scene_->setLayers(layers);
  }
  RgbImage picture() { return scene_->render(kSide_px, kSide_px); }
  Eigen::Vector2d place(const Eigen::Vector3d& p_mm) const {
    const Eigen::Vector4d q = scene_->projection(kSide_px, kSide_px).screen_from_mri * p_mm.homogeneous();
    return q.head<2>() / q.w();
  }
  static RigidTransform<Camera, Mri> cameraPose() { return {Eigen::Quaterniond::Identity(), {0, 0, 600}}; }
  std::unique_ptr<NavigationScene> scene_;
};

TEST_F(SceneLayersTest, ATargetIsDrawnAtItsPlaceOnEitherSide) {
  for (const double x_mm : {-45.0, 45.0}) {
    const auto target = frontTarget("M1", x_mm, 25);
    scene_->setTargets({target}, "M1");
    const Spot spot = find(picture(), isOrange);
    ASSERT_GT(spot.pixels, 40);
    EXPECT_EQ(spot.place.x() > 0, x_mm < 0) << "seen from the front, the patient's left is on the right";
    EXPECT_THAT(spot.place, EigenNear(place(target.scalp_point.mm), 0.03));
  }
}

TEST_F(SceneLayersTest, OnlyTheActiveTargetIsOrange) {
  const auto active = frontTarget("here", -40, 0), other = frontTarget("there", 40, 0);
  scene_->setTargets({other, active}, "here");
  const Spot spot = find(picture(), isOrange);
  ASSERT_GT(spot.pixels, 40);
  EXPECT_THAT(spot.place, EigenNear(place(active.scalp_point.mm), 0.03));
  scene_->setTargets({other, active}, "no such name");
  EXPECT_EQ(find(picture(), isOrange).pixels, 0);
}

TEST_F(SceneLayersTest, TheTargetTurnsBlueOnTargetAndBackAgain) {
  scene_->setTargets({frontTarget("M1", -40, 10)}, "M1");
  const int orange = find(picture(), isOrange).pixels;
  scene_->setOnTarget(true);
  const RgbImage on_target = picture();
  EXPECT_EQ(find(on_target, isOrange).pixels, 0);
  EXPECT_GT(find(on_target, isBlue).pixels, 40);
  scene_->setOnTarget(false);
  EXPECT_EQ(find(picture(), isOrange).pixels, orange);
}

TEST_F(SceneLayersTest, NewTargetsReplaceOldOnesAndTheLayerHidesAll) {
  scene_->setTargets({frontTarget("M1", -40, 10)}, "M1");
  scene_->setTargets({frontTarget("M1", 40, 10)}, "M1");
  EXPECT_LT(find(picture(), isOrange).place.x(), -0.1);
  show([](SceneLayers& layers) { layers.targets = false; });
  EXPECT_EQ(find(picture(), isOrange).pixels, 0);
  show([](SceneLayers&) {});
  scene_->setTargets({}, "");
  EXPECT_EQ(find(picture(), isOrange).pixels, 0);
}

TEST_F(SceneLayersTest, TheBeamRunsAlongTheCoilsAxisFromTheSidesView) {
  // The coil in front of the face, its axis straight back: in the left profile the axis is horizontal.
  const auto target = frontTarget("M1", 0, 20);
  const auto coil = cameraPose() * target.mri_T_target.reframe<Mri, Coil>();
  scene_->setView(ViewPreset::left);
  scene_->setHeadPose({cameraPose(), 1.0});
  scene_->setCoilPose({coil, 1.0});
  ASSERT_TRUE(scene_->showsCoil());
  const RgbImage picture = this->picture();
  const Eigen::Vector2d above = place({0, 115, 20}), below = place({0, 35, 20});  // 35 mm above, 45 below
  int on_beam = 0, steps = 40;
  for (int i = 0; i <= steps; ++i) {
    const Eigen::Vector2d at = above + (below - above) * i / steps;
    const int u = int((at.x() + 1) / 2 * kSide_px), v = int((1 - at.y()) / 2 * kSide_px);
    bool is_hit = false;
    for (int d = -1; d <= 1; ++d) is_hit |= isBlue(picture.pixel(u, v + d));
    on_beam += is_hit;
  }
  EXPECT_GT(on_beam, steps * 8 / 10) << "the housing covers a part of it";
  show([](SceneLayers& layers) { layers.coil_axis = false; });
  EXPECT_LT(find(this->picture(), isBlue).pixels, find(picture, isBlue).pixels / 10);
}

TEST_F(SceneLayersTest, TheCoilLayerHidesTheCoil) {
  scene_->setHeadPose({cameraPose(), 1.0});
  scene_->setCoilPose({cameraPose() * frontTarget("M1", 0, 0).mri_T_target.reframe<Mri, Coil>(), 1.0});
  const auto with = picture();
  EXPECT_TRUE(scene_->showsCoil());
  show([](SceneLayers& layers) { layers.coil = false; });
  EXPECT_FALSE(scene_->showsCoil());
  EXPECT_NE(with.rgb, picture().rgb);
  scene_->setLive(false);
  show([](SceneLayers&) {});
  EXPECT_FALSE(scene_->showsCoil()) << "no live pose, no coil";
}

TEST_F(SceneLayersTest, TheGhostStandsAtThePlannedPose) {
  const RgbImage without = picture();
  for (const double x_mm : {-50.0, 50.0}) {
    const auto target = frontTarget("M1", x_mm, 0);
    scene_->setCoilGhost(target.mri_T_target);
    const RgbImage with = picture();
    double sum_x = 0;
    int changed = 0;
    for (int v = 0; v < 3 * kSide_px / 4; ++v)
      for (int u = 0; u < kSide_px; ++u)
        if (std::abs(with.pixel(u, v)[0] - without.pixel(u, v)[0]) > 8) sum_x += u, ++changed;
    ASSERT_GT(changed, 300);
    EXPECT_EQ(sum_x / changed > 0.5 * kSide_px, x_mm < 0) << x_mm;
  }
  EXPECT_FALSE(scene_->showsCoil()) << "a ghost is no tracked coil";
  scene_->setCoilGhost(std::nullopt);
  EXPECT_EQ(picture().rgb, without.rgb);
}

/// Volume of 60 mm of air with a bright block at the patient's left, behind and below; stored along any axes.
volume::Volume block(const Eigen::Vector3d& signs) {
  volume::Volume mri;
  mri.grid.size = {60, 60, 60};
  mri.grid.mri_from_voxel.linear() = (2 * signs).asDiagonal();
  mri.grid.mri_from_voxel.translation() = -59.0 * signs;
  for (int k = 0; k < 60; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 60; ++i) {
        const Eigen::Vector3d p = mri.grid.toMri(Eigen::Vector3d(i, j, k)).mm;
        const bool is_block =
            p.x() < -15 && p.x() > -45 && p.y() < 20 && p.z() < 20 && p.y() > -30 && p.z() > -30;
        mri.voxels.push_back(is_block ? 200.f : 0.f);
      }
  return mri;
}

bool isBright(const std::uint8_t* p) { return p[0] > 150 && p[1] > 150 && p[2] > 150; }

TEST_F(SceneLayersTest, SlicesShowThePatientsSidesHoweverTheScanIsStored) {
  for (const Eigen::Vector3d& signs : {Eigen::Vector3d(1, 1, 1), {-1, -1, 1}, {-1, 1, -1}}) {
    scene_->setVolume(block(signs));
    scene_->setSliceCentre({-30, 0, 0});
    scene_->setView(ViewPreset::top);
    show([](SceneLayers& layers) { layers.axial = true; });
    const Spot axial = find(picture(), isBright);
    ASSERT_GT(axial.pixels, 200) << signs.transpose();
    EXPECT_THAT(axial.place, EigenNear(place({-30, -5, 0}), 0.03)) << signs.transpose();
    scene_->setView(ViewPreset::front);
    show([](SceneLayers& layers) { layers.coronal = true; });
    EXPECT_THAT(find(picture(), isBright).place, EigenNear(place({-30, 0, -5}), 0.03)) << signs.transpose();
    scene_->setView(ViewPreset::left);
    show([](SceneLayers& layers) { layers.sagittal = true; });
    EXPECT_THAT(find(picture(), isBright).place, EigenNear(place({-30, -5, -5}), 0.03)) << signs.transpose();
  }
}

TEST_F(SceneLayersTest, ASliceBesideTheBlockIsEmptyAndLayersHideIt) {
  scene_->setVolume(block({1, 1, 1}));
  scene_->setView(ViewPreset::left);
  show([](SceneLayers& layers) { layers.sagittal = true; });
  scene_->setSliceCentre({30, 0, 0});
  EXPECT_EQ(find(picture(), isBright).pixels, 0);
  scene_->setSliceCentre({-30, 0, 0});
  EXPECT_GT(find(picture(), isBright).pixels, 200);
  show([](SceneLayers&) {});
  EXPECT_EQ(find(picture(), isBright).pixels, 0);
}

TEST_F(SceneLayersTest, ASliceBeyondTheScanShowsItsLastSlice) {
  scene_->setVolume(block({1, 1, 1}));
  scene_->setView(ViewPreset::left);
  show([](SceneLayers& layers) { layers.sagittal = true; });
  scene_->setSliceCentre({59, 0, 0});
  const auto last = picture();
  scene_->setSliceCentre({500, 0, 0});
  EXPECT_EQ(picture().rgb, last.rgb);
}

TEST_F(SceneLayersTest, TheCoilsSlicesShowWhatLiesUnderTheCoilAndGoWithIt) {
  // A coil on the front of the head, its axis through the block's middle (-30, y, -5) and into the head.
  const auto mri = std::make_shared<const volume::Volume>(block({1, 1, 1}));
  const auto coilOver = [](double x_mm) {
    return cameraPose() * frontTarget("", x_mm, -5).mri_T_target.reframe<Mri, Coil>();
  };
  scene_->setView(ViewPreset::left_front);
  scene_->setCoilSlices(mri);
  EXPECT_FALSE(scene_->showsCoilSlices()) << "there is no coil";
  const auto brightWithCoilOver = [&](double x_mm) {
    scene_->setHeadPose(Tracked<RigidTransform<Camera, Mri>>(cameraPose(), 1.0));
    scene_->setCoilPose(Tracked<RigidTransform<Camera, Coil>>(coilOver(x_mm), 1.0));
    return find(picture(), isBright);
  };
  const int without = brightWithCoilOver(30).pixels;  // the lines and rims of the coil alone
  const Spot block = brightWithCoilOver(-30);
  EXPECT_TRUE(scene_->showsCoilSlices());
  EXPECT_GT(block.pixels, without + 200);
  EXPECT_THAT(block.place, EigenNear(place({-30, 0, -5}), 0.15)) << "where the block is";
  scene_->setCoilPose(Lost{LostReason::no_marker});
  EXPECT_FALSE(scene_->showsCoilSlices());
  EXPECT_LT(find(picture(), isBright).pixels, 50);
  brightWithCoilOver(-30);
  scene_->setCoilSlices(nullptr);
  EXPECT_FALSE(scene_->showsCoilSlices());
}

TEST_F(SceneLayersTest, TheBannerIsShownAndGoesAway) {
  const auto without = picture();
  scene_->setBanner("HEAD LOST");
  EXPECT_NE(picture().rgb, without.rgb);
  scene_->setBanner("");
  EXPECT_EQ(picture().rgb, without.rgb);
}

}  // namespace
}  // namespace facenav::scene
