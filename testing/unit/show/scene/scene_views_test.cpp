// Sides, projections and picks of the 3-D scene. Expected places follow from the viewing direction (closed
// form), not from earlier pictures.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "facenav/scene/display.h"
#include "facenav/scene/navigation_scene.h"
#include "support/ball_mesh.h"
#include "support/matchers.h"

namespace facenav::scene {
namespace {

using testing::EigenNear;

constexpr double kRadius_mm = 100.0;
constexpr ViewPreset kPresets[] = {ViewPreset::target,     ViewPreset::front,      ViewPreset::back,
                                   ViewPreset::left,       ViewPreset::right,      ViewPreset::top,
                                   ViewPreset::left_front, ViewPreset::right_front};

/// Pose of a camera 600 mm in front of the face: Camera x = patient's left, y down.
RigidTransform<Camera, Mri> facingCamera() {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.block<3, 3>(0, 0) << -1, 0, 0, 0, 0, -1, 0, -1, 0;
  m(2, 3) = 600;
  return RigidTransform<Camera, Mri>::fromMatrix(m);
}

class SceneViews : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
    scene_ = std::make_unique<NavigationScene>();
    scene_->setScalp(testing::ballMesh(kRadius_mm, 60, 80));
  }
  /// Place of a point in the view: x right, y up, -1..1.
  Eigen::Vector2d place(const Point<Mri>& p) const {
    const Eigen::Vector4d q = scene_->projection(400, 400).screen_from_mri * p.mm.homogeneous();
    return q.head<2>() / q.w();
  }
  std::unique_ptr<NavigationScene> scene_;
};

TEST_F(SceneViews, FrontAndBackPutThePatientsRightOnOppositeSides) {
  scene_->setView(ViewPreset::front);
  EXPECT_LT(place({50, 0, 0}).x(), -0.1) << "as when facing a person";
  scene_->setView(ViewPreset::back);
  EXPECT_GT(place({50, 0, 0}).x(), 0.1) << "as seen from behind";
}

TEST_F(SceneViews, FromTheSidesTheNosePointsWhereItShould) {
  scene_->setView(ViewPreset::left);
  EXPECT_LT(place({0, 50, 0}).x(), -0.1) << "left profile: nose to the left";
  scene_->setView(ViewPreset::right);
  EXPECT_GT(place({0, 50, 0}).x(), 0.1) << "right profile: nose to the right";
}

TEST_F(SceneViews, FromAboveTheNoseIsUpAndTheRightOnTheRight) {
  scene_->setView(ViewPreset::top);
  EXPECT_GT(place({0, 50, 0}).y(), 0.1);
  EXPECT_GT(place({50, 0, 0}).x(), 0.1);
}

TEST_F(SceneViews, SuperiorIsUpInEveryUprightView) {
  for (const auto preset : kPresets) {
    if (preset == ViewPreset::top) continue;
    scene_->setView(preset);
    EXPECT_GT(place({0, 0, 50}).y(), place({0, 0, 0}).y() + 0.1) << int(preset);
    EXPECT_NEAR(place({0, 0, 50}).x(), place({0, 0, 0}).x(), 1e-3) << int(preset);
  }
}

TEST_F(SceneViews, NoViewMirrorsTheHead) {
  for (const auto preset : kPresets) {
    scene_->setView(preset);
    const auto projection = scene_->projection(300, 200);
    Eigen::Matrix<double, 3, 2> along;  // world directions that move a point right and up on the screen
    for (int axis = 0; axis < 3; ++axis)
      along.row(axis) = 0.5 * (place(Point<Mri>(Eigen::Vector3d::Unit(axis))) -
                               place(Point<Mri>(-Eigen::Vector3d::Unit(axis))))
                                  .transpose();
    const Eigen::Vector3d right = along.col(0), up = along.col(1);
    EXPECT_GT(right.cross(up).dot(projection.eye.mm), 0.0) << int(preset) << ": right x up points to the eye";
  }
}

TEST_F(SceneViews, TheFrontPresetsShowTheSideTheyName) {
  scene_->setView(ViewPreset::left_front);
  EXPECT_LT(scene_->projection(200, 200).eye.mm.x(), -100.0);
  scene_->setView(ViewPreset::right_front);
  EXPECT_GT(scene_->projection(200, 200).eye.mm.x(), 100.0);
  for (const auto preset : {ViewPreset::left_front, ViewPreset::right_front}) {
    scene_->setView(preset);
    EXPECT_GT(scene_->projection(200, 200).eye.mm.y(), 100.0);
  }
}

TEST_F(SceneViews, TheHeadsSizeOnTheScreenDoesNotDependOnItsSize) {
  const auto edge = [&](double radius_mm) {
    scene_->setScalp(testing::ballMesh(radius_mm));
    scene_->setView(ViewPreset::front);
    return place({0, 0, radius_mm}).y();
  };
  EXPECT_NEAR(edge(110.0), edge(70.0), 1e-3) << "a child's head fills the view as well";
}

TEST_F(SceneViews, TheCameraViewIsThePinholeOfItsAngle) {
  const double angle_rad = 0.62, half = std::tan(0.5 * angle_rad);
  scene_->setHeadPose({facingCamera(), 1.0});
  scene_->setCameraAngle(angle_rad);
  scene_->setViewFrame(ViewFrame::camera);
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(40, 95, 30), {-60, 60, -20}, {0, 100, 0}}) {
    const Eigen::Vector3d in_camera = facingCamera().isometry() * p;
    const Eigen::Vector2d expected =
        Eigen::Vector2d(in_camera.x(), -in_camera.y()) / (in_camera.z() * half);  // y of the screen points up
    EXPECT_THAT(place(Point<Mri>(p)), EigenNear(expected, 1e-6));
  }
  EXPECT_THAT(scene_->projection(400, 400).eye.mm, EigenNear(Eigen::Vector3d(0, 600, 0), 1e-6));
}

TEST_F(SceneViews, AWideViewStretchesNothing) {
  scene_->setView(ViewPreset::front);
  const auto at = [&](int width, int height) {
    const Eigen::Vector4d q =
        scene_->projection(width, height).screen_from_mri * Eigen::Vector4d(30, 0, 40, 1);
    return Eigen::Vector2d(q.x() / q.w() * width, q.y() / q.w() * height);  // half pixels from the centre
  };
  EXPECT_THAT(at(800, 300), EigenNear(at(300, 300), 1e-6));
}

TEST_F(SceneViews, APickGivesThePlaceThatWasClicked) {
  for (const auto preset : {ViewPreset::front, ViewPreset::left, ViewPreset::top, ViewPreset::right_front}) {
    scene_->setView(preset);
    scene_->render(400, 400);
    const Eigen::Vector3d towards_eye = scene_->projection(400, 400).eye.mm.normalized();
    for (const Eigen::Vector3d& away : {Eigen::Vector3d(0, 0, 0), {0.3, 0.2, -0.1}, {-0.25, 0.1, 0.35}}) {
      const Eigen::Vector3d p = kRadius_mm * (towards_eye + away).normalized();
      const Eigen::Vector2d at = (place(Point<Mri>(p)) + Eigen::Vector2d::Ones()) * 200.0;
      const auto pick = scene_->pick(int(std::floor(at.x())), int(std::floor(at.y())));
      ASSERT_TRUE(pick) << int(preset);
      EXPECT_LT((pick->point.mm - p).norm(), 1.2) << int(preset) << ": a pixel is 0.7 mm here";
    }
  }
}

TEST_F(SceneViews, APickInTheCameraViewIsInMri) {
  const RigidTransform<Camera, Camera> moved(
      Eigen::Quaterniond(Eigen::AngleAxisd(0.2, Eigen::Vector3d(1, 2, 0.5).normalized())), {15, -10, 30});
  scene_->setHeadPose({moved * facingCamera(), 1.0});
  scene_->setViewFrame(ViewFrame::camera);
  scene_->render(400, 400);
  const Eigen::Vector3d p = kRadius_mm * Eigen::Vector3d(0.3, 0.9, 0.2).normalized();
  const Eigen::Vector2d at = (place(Point<Mri>(p)) + Eigen::Vector2d::Ones()) * 200.0;
  const auto pick = scene_->pick(int(std::floor(at.x())), int(std::floor(at.y())));
  ASSERT_TRUE(pick);
  EXPECT_LT((pick->point.mm - p).norm(), 2.0) << "a pixel is 0.8 mm here";
}

TEST_F(SceneViews, WhatIsHiddenCannotBePicked) {
  scene_->setView(ViewPreset::front);
  scene_->render(200, 200);
  ASSERT_TRUE(scene_->pick(100, 100));
  SceneLayers bare;
  bare.scalp = false;
  scene_->setLayers(bare);
  EXPECT_FALSE(scene_->pick(100, 100));
}

TEST_F(SceneViews, ASharedCameraShowsTheSameView) {
  NavigationScene other;
  other.setScalp(testing::ballMesh(kRadius_mm));
  other.setView(ViewPreset::left);
  scene_->shareCamera(other);
  const Eigen::Matrix4d of_other = other.projection(200, 200).screen_from_mri;
  EXPECT_LT((scene_->projection(200, 200).screen_from_mri - of_other).cwiseAbs().maxCoeff(), 1e-12);
  other.setView(ViewPreset::top);
  EXPECT_GT((scene_->projection(200, 200).screen_from_mri - of_other).cwiseAbs().maxCoeff(), 0.1);
}

}  // namespace
}  // namespace facenav::scene
