#include "facenav/health/face_offset.h"

#include <gtest/gtest.h>

#include <random>

#include "support/stereo_rigs.h"

namespace facenav::health {

using namespace cameras;
namespace {

/// Matches of a face 600 mm away whose head moved by `moved_mm` (Camera) before the right camera exposed.
std::vector<Correspondence> seen(const StereoRig& rig, const Eigen::Vector3d& moved_mm) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise_px(0, 0.2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Eigen::Vector3d middle_mm =
      0.5 * rig.right_T_left.inverse().translation_mm() + Eigen::Vector3d(0, 0, 600);
  std::vector<Correspondence> matches;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d at_mm =
        middle_mm + Eigen::Vector3d(70 * uniform(random), 80 * uniform(random), 40 * uniform(random));
    const Eigen::Vector2d right_px =
        project(rig.right, rig.right_T_left.isometry() * Eigen::Vector3d(at_mm + moved_mm));
    matches.push_back(
        {project(rig.left, at_mm), right_px + Eigen::Vector2d(noise_px(random), noise_px(random)), 0.2});
  }
  return matches;
}

/// Unit vector across the epipolar lines, Camera, and one along the baseline.
Eigen::Vector3d across(const StereoRig& rig) {
  return Eigen::Vector3d::UnitZ().cross(rig.right_T_left.inverse().translation_mm()).normalized();
}
Eigen::Vector3d along(const StereoRig& rig) {
  return rig.right_T_left.inverse().translation_mm().normalized();
}

TEST(FaceOffset, IsNothingForOneMoment) {
  for (const auto& rig : {testing::convergingRig(), testing::verticalRig(), testing::rolledRig()}) {
    const auto offset = faceOffset(rig, seen(rig, Eigen::Vector3d::Zero()));
    EXPECT_FALSE(offset.isSignificant());
    EXPECT_NEAR(offset.median_px, 0, 0.05);
    EXPECT_NEAR(offset.depth_mm, 600, 40);
  }
  EXPECT_FALSE(faceOffset(testing::convergingRig(), {}).isSignificant());
}

// A motion as far along the lines as across them: the offset that it leaves, and the error of depth.
TEST(FaceOffset, TellsTheErrorOfDepthThatTwoMomentsMean) {
  for (const auto& rig : {testing::convergingRig(), testing::verticalRig(), testing::rolledRig()}) {
    const auto offset = faceOffset(rig, seen(rig, 2.0 * across(rig)));
    EXPECT_TRUE(offset.isSignificant());
    const double still_mm = faceOffset(rig, seen(rig, Eigen::Vector3d::Zero())).depth_mm,
                 wrong_mm = std::abs(faceOffset(rig, seen(rig, 2.0 * along(rig))).depth_mm - still_mm);
    EXPECT_NEAR(std::abs(offset.median_px) / offsetOfDepthError_px(rig, wrong_mm, still_mm), 1, 0.25);
  }
}

TEST(FaceOffset, IsWithinTheErrorOfACoarseCalibration) {
  auto rig = testing::convergingRig();
  const auto matches = seen(rig, 0.4 * across(rig));
  rig.rms_px = 0.1;
  EXPECT_TRUE(faceOffset(rig, matches).isSignificant());
  rig.rms_px = 2.0;
  EXPECT_FALSE(faceOffset(rig, matches).isSignificant());
}

}  // namespace
}  // namespace facenav::health
