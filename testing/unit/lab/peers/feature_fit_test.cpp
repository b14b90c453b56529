#include <gtest/gtest.h>

#include <random>

#include "feature_fit.h"
#include "support/synthetic_face.h"

namespace facenav::peers {
namespace {

// Eye corners, nose tip, mouth corners of an adult face 600 mm away.
const std::vector<Eigen::Vector3d> kFace_mm = {{-45, -34, 612}, {-16, -33, 606}, {16, -33, 606},
                                               {45, -34, 612},  {0, 0, 580},     {-26, 34, 600},
                                               {26, 34, 600}};

Eigen::Isometry3d someMotion() {
  Vector6d xi;
  xi << 0.08, -0.12, 0.05, 12, -9, 20;
  return Eigen::Translation3d(0, 0, 600) * expRigid(xi) * Eigen::Translation3d(0, 0, -600);
}

std::vector<FeatureMatch> matches(const cameras::StereoRig& rig, double sigma_px, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, sigma_px);
  std::vector<FeatureMatch> found;
  for (int i = 0; i < int(kFace_mm.size()); ++i) {
    const Eigen::Vector3d p_mm = someMotion() * kFace_mm[i];
    const auto jitter = [&] {
      return sigma_px > 0 ? Eigen::Vector2d(noise(random), noise(random)) : Eigen::Vector2d(0, 0);
    };
    found.push_back({i, cameras::project(rig.left, p_mm) + jitter(),
                     cameras::project(rig.right, rig.right_T_left.isometry() * p_mm) + jitter(), 0.95});
  }
  return found;
}

TEST(FeatureFit, ExactMatchesGiveTheExactMotion) {
  const auto rig = facenav::testing::faceRig();
  const auto fit = fitFeatures(rig, kFace_mm, matches(rig, 0.0, 1));
  ASSERT_TRUE(fit.isTracked());
  EXPECT_LT((fit->motion.matrix() - someMotion().matrix()).cwiseAbs().maxCoeff(), 1e-4);
  EXPECT_EQ(fit->inliers.size(), 7u);
}

// Expected for 7 features at 0.25 px: 0.85 deg triangulated, 0.24 deg by the joint fit in the images.
TEST(FeatureFit, QuarterPixelNoiseGivesAQuarterDegreeFittedInTheImages) {
  const auto rig = facenav::testing::faceRig();
  double squares = 0, claimed = 0;
  const int trials = 100;
  for (int trial = 0; trial < trials; ++trial) {
    const auto fit = fitFeatures(rig, kFace_mm, matches(rig, 0.25, 100 + trial));
    ASSERT_TRUE(fit.isTracked());
    squares +=
        std::pow(rotationAngle(fit->motion.linear().transpose() * someMotion().linear()) * 180 / M_PI, 2);
    claimed += fit->covariance.topLeftCorner<3, 3>().trace() * std::pow(180 / M_PI, 2);
  }
  EXPECT_LT(std::sqrt(squares / (3 * trials)), 0.25) << "about each axis";
  const double claim = std::sqrt(claimed / squares);  // the predicted error assumes at least 0.35 px
  EXPECT_GT(claim, 0.95) << "the covariance is honest";
  EXPECT_LT(claim, 1.9);
}

TEST(FeatureFit, SwappedEyeCornersAreThrownOut) {
  const auto rig = facenav::testing::faceRig();
  auto found = matches(rig, 0.1, 5);
  std::swap(found[0].left_px, found[3].left_px);
  std::swap(found[0].right_px, found[3].right_px);
  const auto fit = fitFeatures(rig, kFace_mm, found);
  ASSERT_TRUE(fit.isTracked());
  EXPECT_EQ(fit->inliers.size(), 5u);
  for (const auto& match : fit->inliers) EXPECT_TRUE(match.feature != 0 && match.feature != 3);
  EXPECT_LT(rotationAngle(fit->motion.linear().transpose() * someMotion().linear()) * 180 / M_PI, 1.0);
}

TEST(FeatureFit, AllFourEyeCornersSwappedIsLost) {
  const auto rig = facenav::testing::faceRig();
  auto found = matches(rig, 0.1, 6);
  for (auto [a, b] : {std::pair(0, 3), std::pair(1, 2)}) {
    std::swap(found[a].left_px, found[b].left_px);
    std::swap(found[a].right_px, found[b].right_px);
  }
  const auto fit = fitFeatures(rig, kFace_mm, found);
  ASSERT_FALSE(fit.isTracked());
  EXPECT_EQ(fit.reason(), LostReason::high_residual);
}

TEST(FeatureFit, LeftAndRightSwappedIsLost) {
  const auto rig = facenav::testing::faceRig();
  auto found = matches(rig, 0.1, 7);
  for (auto& match : found) std::swap(match.left_px, match.right_px);
  EXPECT_FALSE(fitFeatures(rig, kFace_mm, found).isTracked());
}

TEST(FeatureFit, FourFeaturesAreTooFew) {
  const auto rig = facenav::testing::faceRig();
  auto found = matches(rig, 0.1, 8);
  found.resize(4);
  const auto fit = fitFeatures(rig, kFace_mm, found);
  ASSERT_FALSE(fit.isTracked());
  EXPECT_EQ(fit.reason(), LostReason::few_features);
}

}  // namespace
}  // namespace facenav::peers
