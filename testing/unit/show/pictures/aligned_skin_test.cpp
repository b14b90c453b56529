// The MRI's skin over the pictures: balls whose outline is known in closed form.

#include "facenav/pictures/aligned_skin.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/ball_mesh.h"

namespace facenav::pictures {
namespace {

constexpr double kFocal_px = 800, kRadius_mm = 60, kDepth_mm = 600;
constexpr int kWidth_px = 640, kHeight_px = 480;

cameras::StereoRig rig() {
  cameras::StereoRig rig;
  rig.width_px = kWidth_px, rig.height_px = kHeight_px;
  rig.left.k = rig.right.k = cv::Matx33d(kFocal_px, 0, 320, 0, kFocal_px, 240, 0, 0, 1);
  rig.right_T_left = RigidTransform<RightCamera, Camera>(Eigen::Quaterniond::Identity(), {-60, 0, 0});
  return rig;
}

surface::TriangleMesh movedBall(double radius_mm, const Eigen::Vector3d& by_mm) {
  auto ball = testing::ballMesh(radius_mm, 90, 120);
  for (auto& vertex : ball.vertices_mm) vertex += by_mm;
  return ball;
}

surface::TriangleMesh together(surface::TriangleMesh a, const surface::TriangleMesh& b) {
  const int first = int(a.vertices_mm.size());
  a.vertices_mm.insert(a.vertices_mm.end(), b.vertices_mm.begin(), b.vertices_mm.end());
  a.normals.insert(a.normals.end(), b.normals.begin(), b.normals.end());
  for (const auto& t : b.triangles) a.triangles.emplace_back(t.array() + first);
  return a;
}

Eigen::Isometry3d ahead() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation().z() = kDepth_mm;
  return pose;
}

std::vector<ContourPiece> contourOf(const surface::TriangleMesh& mesh) {
  return occludingContour(mesh, ahead(), rig().left, kWidth_px, kHeight_px);
}

double radiusOf(const ContourPiece& piece) {
  return (0.5 * (piece.from_px + piece.to_px) - Eigen::Vector2d(320, 240)).norm();
}

TEST(AlignedSkin, TheContourOfABallIsItsRim) {
  const double rim_px = kFocal_px * kRadius_mm / std::sqrt(kDepth_mm * kDepth_mm - kRadius_mm * kRadius_mm);
  const auto pieces = contourOf(movedBall(kRadius_mm, {0, 0, 0}));
  double length_px = 0;
  for (const auto& piece : pieces) {
    EXPECT_NEAR(radiusOf(piece), rim_px, 0.3);
    length_px += (piece.to_px - piece.from_px).norm();
  }
  EXPECT_NEAR(length_px, 2 * M_PI * rim_px, 0.02 * 2 * M_PI * rim_px) << "closed, and drawn once";
}

TEST(AlignedSkin, ARimBeforeOtherSkinIsDrawnAndOneBehindItIsNot) {
  const auto head = movedBall(kRadius_mm, {0, 0, 0}), nose = movedBall(12, {0, 0, -kRadius_mm});
  const auto withNose = contourOf(together(head, nose));
  const auto alone = contourOf(head).size();
  const auto isInner = [](const ContourPiece& piece) { return radiusOf(piece) < 30; };
  EXPECT_GT(std::count_if(withNose.begin(), withNose.end(), isInner), 50) << "the rim of the nose";
  const auto hidden = contourOf(together(head, movedBall(12, {0, 0, kRadius_mm})));
  EXPECT_EQ(hidden.size(), alone) << "nothing is seen of a ball behind the head";
}

TEST(AlignedSkin, ThinningKeepsTheRimWithinATenthOfAPixel) {
  const auto skin = makeAlignedSkin(testing::ballMesh(kRadius_mm, 300, 600), {});
  EXPECT_LT(skin.mesh.vertices_mm.size(), 12000u);
  const double rim_px = kFocal_px * kRadius_mm / std::sqrt(kDepth_mm * kDepth_mm - kRadius_mm * kRadius_mm);
  double sum_px = 0;
  const auto pieces = contourOf(skin.mesh);
  ASSERT_GT(pieces.size(), 50u);
  for (const auto& piece : pieces) sum_px += radiusOf(piece);
  EXPECT_NEAR(sum_px / double(pieces.size()), rim_px, 0.25);
}

TEST(AlignedSkin, BothPicturesShowTheSkinWhereThePosePutsIt) {
  cameras::StereoFrame frame;
  frame.left = cv::Mat(kHeight_px, kWidth_px, CV_8UC1, cv::Scalar(100));
  frame.right = frame.left.clone();
  const RigidTransform<Camera, Mri> pose(Eigen::Quaterniond::Identity(), {0, 0, kDepth_mm});
  const auto skin = makeAlignedSkin(
      movedBall(kRadius_mm, {0, 0, 0}),
      {{"nose tip", Point<Mri>(0, 0, -kRadius_mm), 1.0}, {"inion", Point<Mri>(0, 0, kRadius_mm), 1.0}});
  const auto drawn = drawAlignedSkin(rig(), frame, pose, skin);
  const auto isDrawn = [](const RgbImage& image, int u, int v) {
    const auto* p = image.pixel(u, v);
    return std::abs(p[0] - 100) > 20 || std::abs(p[2] - 100) > 20;
  };
  EXPECT_TRUE(isDrawn(drawn.left, 320 + 80, 240) || isDrawn(drawn.left, 320 + 81, 240));
  // 800 * 60 / 600 = 80 px further left in the right camera.
  EXPECT_TRUE(isDrawn(drawn.right, 320, 240) || isDrawn(drawn.right, 321, 240));
  EXPECT_TRUE(isDrawn(drawn.left, 320, 240)) << "the cross at the nose's tip";
  EXPECT_FALSE(isDrawn(drawn.left, 320 + 100, 240)) << "nothing beside the head";
}

}  // namespace
}  // namespace facenav::pictures
