#include "cloud/skin_patches.h"

#include <gtest/gtest.h>

#include <random>

namespace facenav::registration {
namespace {

/// Matches on the plane y = 90 mm, a square of `side_mm`, `per_mm2` a square millimetre.
std::vector<PointMatch> onAPlane(double side_mm, int count, double residual_mm, double noise_mm) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> uniform(0, float(side_mm));
  std::normal_distribution<double> normal;
  std::vector<PointMatch> matches;
  for (int i = 0; i < count; ++i) {
    PointMatch match;
    match.at_mri_mm = {uniform(random), 90.f, uniform(random)};
    match.normal_mri = Eigen::Vector3f::UnitY();
    match.residual_mm = float(residual_mm + noise_mm * normal(random));
    match.is_valid = true;
    matches.push_back(match);
  }
  return matches;
}

Eigen::Isometry3d cameraAt(const Eigen::Vector3d& p_mri_mm) {
  Eigen::Isometry3d mri_T_camera = Eigen::Isometry3d::Identity();
  mri_T_camera.translation() = p_mri_mm;
  return mri_T_camera;
}

const Eigen::Isometry3d kBefore = cameraAt({30, 690, 30});
const Eigen::Vector3d kPivot(5, 10, 15);

TEST(SkinPatches, AverageWhatLiesInThem) {
  const auto patches = gatherPatches(onAPlane(48, 4000, 0.4, 0.1), {12.0, 1.5, 1.5}, kBefore, kPivot);
  ASSERT_EQ(patches.size(), 16u);
  int points = 0;
  for (const SkinPatch& patch : patches) {
    points += patch.points;
    EXPECT_NEAR(patch.residual_mm, 0.4, 0.04);
    EXPECT_NEAR(patch.normal.y(), 1.0, 1e-6);
    EXPECT_NEAR(patch.at_mri_mm.y(), 90.0, 1e-4);
    EXPECT_EQ(patch.covered, 1.0);
    // The jacobian is that of the patch's middle: a plane.
    const Eigen::Vector3d turn = (patch.at_mri_mm - kPivot).cross(Eigen::Vector3d::UnitY());
    EXPECT_LT((patch.jacobian.head<3>() - turn).norm(), 1e-3);
    EXPECT_LT((patch.jacobian.tail<3>() - Eigen::Vector3d::UnitY()).norm(), 1e-5);
    EXPECT_GT(patch.noise_mm, 0.04) << "never taken for exact";
    EXPECT_LT(patch.noise_mm, 0.1) << "less than a single point's";
  }
  EXPECT_EQ(points, 4000);
}

TEST(SkinPatches, ResidualsBeyondTheLimitsAreLeftOutAndCounted) {
  auto matches = onAPlane(11.9, 400, 0.0, 0.05);
  for (std::size_t m = 0; m < 100; ++m) matches[m].residual_mm = 2.0f;     // hair
  for (std::size_t m = 100; m < 150; ++m) matches[m].residual_mm = 50.0f;  // another object
  for (std::size_t m = 150; m < 200; ++m) matches[m].is_valid = false;
  const auto patches = gatherPatches(matches, {12.0, 1.0, 1.0}, kBefore, kPivot);
  ASSERT_EQ(patches.size(), 1u);
  EXPECT_EQ(patches[0].points, 200);
  EXPECT_NEAR(patches[0].covered, 200.0 / 300, 1e-9);
  EXPECT_NEAR(patches[0].residual_mm, 0.0, 0.02);
}

TEST(SkinPatches, LimitsInsideAndOutsideDiffer) {
  auto matches = onAPlane(11.9, 100, 0.8, 0.0);
  EXPECT_EQ(gatherPatches(matches, {12.0, 0.5, 1.5}, kBefore, kPivot).size(), 1u);
  EXPECT_TRUE(gatherPatches(matches, {12.0, 1.5, 0.5}, kBefore, kPivot).empty());
  for (auto& match : matches) match.residual_mm = -0.8f;
  EXPECT_TRUE(gatherPatches(matches, {12.0, 0.5, 1.5}, kBefore, kPivot).empty());
}

TEST(SkinPatches, FourPointsAreNone) {
  EXPECT_TRUE(gatherPatches(onAPlane(11.9, 4, 0, 0), {}, kBefore, kPivot).empty());
  EXPECT_EQ(gatherPatches(onAPlane(11.9, 5, 0, 0), {}, kBefore, kPivot).size(), 1u);
  EXPECT_TRUE(gatherPatches({}, {}, kBefore, kPivot).empty());
}

TEST(SkinPatches, SkinSeenFromTheSideIsLessCertain) {
  const auto matches = onAPlane(48, 4000, 0.0, 0.1);
  const auto noise_mm = [&](const Eigen::Vector3d& camera_mm) {
    return gatherPatches(matches, {}, cameraAt(camera_mm), kPivot).front().noise_mm;
  };
  const double before = noise_mm({30, 690, 30}), aslant = noise_mm({630, 690, 30}),
               side = noise_mm({1000, 190, 30});
  EXPECT_GT(aslant, 1.3 * before);
  EXPECT_GT(side, 1.5 * aslant);
}

}  // namespace
}  // namespace facenav::registration
