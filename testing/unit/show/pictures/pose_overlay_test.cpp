#include "facenav/pictures/pose_overlay.h"

#include <gtest/gtest.h>

#include "support/ball_mesh.h"
#include "unit/treat/session/session_fakes.h"

namespace facenav::pictures {
namespace {

namespace fakes = session::fakes;

/// Number of pixels that are not the picture's grey, below the caption.
int drawnPixels(const RgbImage& image) {
  int drawn = 0;
  for (int v = 20; v < image.height_px; ++v)
    for (int u = 0; u < image.width_px; ++u)
      drawn += std::abs(image.pixel(u, v)[0] - image.pixel(u, v)[2]) > 30;
  return drawn;
}

/// Poses of a head of 40 mm radius on the left camera's axis, 400 mm away.
StoredPoses headInView() {
  StoredPoses poses;
  poses.camera_T_mri = RigidTransform<Camera, Mri>(Eigen::Quaterniond::Identity(), {0, 0, 400});
  return poses;
}

TEST(PoseOverlay, TheScalpsOutlineLiesWhereTheHeadsPosePutsIt) {
  const auto scalp = testing::ballMesh(40, 40, 60);
  const auto overlay = drawPoses(fakes::rig(), *fakes::frame(0, 0), headInView(), scalp, {});
  const auto isBlue = [](const RgbImage& image, int u, int v) {
    const auto* p = image.pixel(u, v);
    return p[2] > p[0] + 30;
  };
  const auto nearRim = [&](const RgbImage& image, int u, int v) {
    return isBlue(image, u, v) || isBlue(image, u + 1, v) || isBlue(image, u - 1, v);
  };
  // f 80 px: the rim is seen 80 * 40 / sqrt(400^2 - 40^2) = 8.04 px from the middle (32, 24).
  EXPECT_TRUE(nearRim(overlay.left, 40, 24));
  EXPECT_TRUE(nearRim(overlay.left, 24, 24));
  EXPECT_FALSE(isBlue(overlay.left, 32, 24)) << "only the outline";
  EXPECT_FALSE(isBlue(overlay.left, 46, 24));
  EXPECT_TRUE(nearRim(overlay.right, 16, 24)) << "80 * 120 / 400 = 24 px further left";
  EXPECT_FALSE(nearRim(overlay.right, 40, 24));
}

TEST(PoseOverlay, TheCoilIsDrawnInFrontOfEachCameraThatSeesIt) {
  StoredPoses poses;
  poses.camera_T_coil = RigidTransform<Camera, Coil>(Eigen::Quaterniond::Identity(), {60, 20, 500});
  guidance::CoilPlate plate;
  plate.outline_mm = {{-40, -20}, {40, -20}, {40, 20}, {-40, 20}};
  const auto overlay = drawPoses(fakes::rig(), *fakes::frame(0, 0), poses, {}, plate);
  EXPECT_GT(drawnPixels(overlay.left), 10);
  EXPECT_GT(drawnPixels(overlay.right), 10);
}

TEST(PoseOverlay, NothingIsDrawnOfAPoseThatIsNotKnown) {
  StoredPoses poses;
  poses.target = fakes::targetAt({Eigen::Quaterniond::Identity(), {0, 0, 400}}).target;
  poses.loss = "face lost: no_face";
  const auto overlay = drawPoses(fakes::rig(), *fakes::frame(0, 0), poses, testing::ballMesh(40, 40, 60), {});
  EXPECT_EQ(drawnPixels(overlay.left), 0);
  EXPECT_EQ(drawnPixels(overlay.right), 0);
}

}  // namespace
}  // namespace facenav::pictures
