#include "recovery/sides.h"

#include <gtest/gtest.h>

#include <random>

#include "facenav/head_tracking/identity_model.h"
#include "facenav/head_tracking/step_limits.h"
#include "recovery/identity.h"
#include "support/changed_settings.h"
#include "support/stereo_rigs.h"

namespace facenav::head_tracking {
namespace {

using facenav::testing::ChangedSettings;

/// Points of a face at 600 mm as both cameras see them, the right picture shifted by `shift_px`, with noise.
std::vector<SkinMatch> matchesOf(const cameras::StereoRig& rig, const Eigen::Vector2d& shift_px,
                                 double noise_px, int points = 200) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::normal_distribution<double> normal;
  std::vector<SkinMatch> matches;
  for (int i = 0; i < points; ++i) {
    const Eigen::Vector3d p_mm(60 * uniform(random), 70 * uniform(random), 600 + 25 * uniform(random));
    SkinMatch left, right;
    left.point = right.point = i, right.camera = 1;
    left.px = cameras::project(rig.left, p_mm);
    right.px = cameras::project(rig.right, rig.right_T_left.isometry() * p_mm) + shift_px +
               noise_px * Eigen::Vector2d(normal(random), normal(random));
    matches.push_back(left), matches.push_back(right);
  }
  return matches;
}

TEST(EpipolarOffset, OfAPairOfOneMomentIsNothing) {
  for (const auto& rig : {facenav::testing::convergingRig(), facenav::testing::verticalRig()}) {
    const EpipolarOffset offset = epipolarOffset(rig, matchesOf(rig, {0, 0}, 0));
    EXPECT_EQ(offset.points, 200);
    EXPECT_NEAR(offset.median_px, 0, 1e-3);
    EXPECT_NEAR(offset.spread_px, 0, 1e-3);
    EXPECT_FALSE(offset.isOutOfStep());
  }
}

TEST(EpipolarOffset, IsTheShiftAcrossTheLinesAndBlindAlongThem) {
  const auto rig = facenav::testing::convergingRig();  // side by side: lines run along x
  EXPECT_NEAR(std::abs(epipolarOffset(rig, matchesOf(rig, {0, 0.8}, 0)).median_px), 0.8, 0.03);
  EXPECT_NEAR(epipolarOffset(rig, matchesOf(rig, {5, 0}, 0)).median_px, 0, 0.15);
  const auto above = facenav::testing::verticalRig();
  EXPECT_NEAR(std::abs(epipolarOffset(above, matchesOf(above, {0.8, 0}, 0)).median_px), 0.8, 0.03);
  const double down = epipolarOffset(rig, matchesOf(rig, {0, 0.8}, 0)).median_px,
               up = epipolarOffset(rig, matchesOf(rig, {0, -0.8}, 0)).median_px;
  EXPECT_NEAR(down, -up, 1e-2) << "it has a sign";
}

// Two moments make the depth wrong by centimetres: that must not pass for a fast head, whose motion between
// the exposures of untriggered cameras would explain the offset.
TEST(EpipolarOffset, IsExplainedByMotionAcrossTheLinesAlone) {
  const auto rig = facenav::testing::convergingRig();
  const Eigen::Vector3d at_mm(50, 20, 600),
      along_mm = rig.right_T_left.isometry().inverse().translation().normalized();
  EXPECT_NEAR(motionAcrossLines_mm(rig, at_mm, 1.05 * at_mm), 0, 1e-9) << "nearer or farther";
  EXPECT_NEAR(motionAcrossLines_mm(rig, at_mm, at_mm + 20 * along_mm), 0, 1e-9);
  EXPECT_NEAR(motionAcrossLines_mm(rig, at_mm, at_mm + Eigen::Vector3d(0, 3, 0)), 3, 0.01);
  const auto above = facenav::testing::verticalRig();
  EXPECT_NEAR(motionAcrossLines_mm(above, {0, 0, 600}, {3, 0, 600}), 3, 0.01);
}

TEST(EpipolarOffset, TheSpreadIsTheNoiseAndFewOutliersChangeNeither) {
  const auto rig = facenav::testing::convergingRig();
  auto matches = matchesOf(rig, {0, 0.5}, 0.3, 600);
  for (std::size_t m = 1; m < matches.size(); m += 20) matches[m].px.y() += 40;  // a tenth of the right ones
  const EpipolarOffset offset = epipolarOffset(rig, matches);
  EXPECT_NEAR(std::abs(offset.median_px), 0.5, 0.1);
  EXPECT_NEAR(offset.spread_px, 0.3, 0.08);
}

TEST(EpipolarOffset, OnlyPointsInBothCamerasCount) {
  const auto rig = facenav::testing::convergingRig();
  auto matches = matchesOf(rig, {0, 0}, 0, 60);
  for (auto& match : matches)
    if (match.point >= 40 && match.camera == 1) match.point += 1000;
  EXPECT_EQ(epipolarOffset(rig, matches).points, 40);
  EXPECT_EQ(epipolarOffset(rig, {}).points, 0);
  EXPECT_FALSE(epipolarOffset(rig, {}).isOutOfStep());
}

TEST(EpipolarOffset, LimitsDecideAndMayBeChanged) {
  const EpipolarOffset offset{400, 0.3, 0.4, 0.2};  // its median is known to 0.03 px
  EXPECT_TRUE(offset.isOutOfStep());
  EXPECT_FALSE(offset.isOutOfStep(0.2)) << "the head's own motion explains it";
  EXPECT_FALSE((EpipolarOffset{39, 0.9, 0.1, 0.2}.isOutOfStep())) << "too few points";
  EXPECT_FALSE((EpipolarOffset{40, 0.3, 0.4, 0.2}.isOutOfStep())) << "known to 0.1 px only";
  EXPECT_TRUE((EpipolarOffset{400, -0.3, 0.4, 0.2}.isOutOfStep())) << "either way";
  ChangedSettings<StepLimits> limits;
  limits->step_fewest = 500;
  EXPECT_FALSE(offset.isOutOfStep());
}

/// What matters is a length in front of the cameras, whatever their lens and distance.
TEST(EpipolarOffset, MattersFromAnErrorOfTheDepthOn) {
  const auto rig = facenav::testing::convergingRig();
  const double depth_mm = 600, f_px = rig.right.k(1, 1);
  const auto harmful_px = [&] { return epipolarOffset(rig, matchesOf(rig, {0, 0}, 0)).harmful_px; };
  ChangedSettings<StepLimits> limits;
  limits->step_harm_mm = 3.0;
  const double expected_px = 3.0 * rig.baseline_mm() / depth_mm * f_px / depth_mm;
  EXPECT_NEAR(harmful_px(), expected_px, 0.1 * expected_px);
  limits->step_harm_mm = 0.1;
  EXPECT_NEAR(harmful_px(), rig.rms_px.value_or(0.2), 1e-6) << "not below what the calibration leaves";
}

TEST(EpipolarOffset, IsCleanWherePointsLieOnTheirLines) {
  EXPECT_TRUE((EpipolarOffset{400, 0.2, 0.3, 0.5}.isClean()));
  EXPECT_FALSE((EpipolarOffset{400, 0.2, 0.9, 0.5}.isClean())) << "parts of the face lie apart";
  EXPECT_FALSE((EpipolarOffset{400, 0.6, 0.1, 0.5}.isClean())) << "shifted";
  EXPECT_FALSE((EpipolarOffset{20, 0.0, 0.1, 0.5}.isClean())) << "too few points";
}

TEST(EpipolarOffset, OfAStrangerMustBeClear) {
  EXPECT_TRUE((EpipolarOffset{400, 1.5, 0.5, 0.2}.isClearlyOutOfStep()));
  EXPECT_FALSE((EpipolarOffset{400, 1.2, 0.5, 0.2}.isClearlyOutOfStep()))
      << "1 px and 8 standard errors of 0.03";
  EXPECT_FALSE((EpipolarOffset{400, 9.0, 2.5, 0.2}.isClearlyOutOfStep())) << "chance matches lie anywhere";
  EXPECT_FALSE((EpipolarOffset{30, 9.0, 0.5, 0.2}.isClearlyOutOfStep()));
}

TEST(StepWatch, OffsetsThatChangeTheirSignAreChance) {
  StepWatch watch;
  for (int i = 0; i < 10; ++i) {
    const EpipolarOffset offset{400, i % 2 ? 0.3 : -0.3, 0.4, 0.2};
    EXPECT_NE(watch.judge(offset, 0, Timestamp{0.1 * i}), StepVerdict::out_of_step) << i;
  }
}

// Out of step by a fixed delay: the offset follows the head's speed across the lines, and is zero where a
// swaying head turns back.
TEST(StepWatch, IsNotSureOfOneGoodAnswerAfterTwoMoments) {
  StepWatch watch;
  const auto at = [&](double t_s, double off_px) {
    return watch.judge(EpipolarOffset{400, off_px, 0.3, 0.18}, 0, Timestamp{t_s});
  };
  EXPECT_EQ(at(0.0, -0.51), StepVerdict::out_of_step);
  EXPECT_EQ(at(0.1, 0.07), StepVerdict::out_of_step) << "together with the answer before";
  EXPECT_EQ(at(0.2, 0.05), StepVerdict::unsure);
  EXPECT_EQ(at(0.9, 0.05), StepVerdict::unsure);
  EXPECT_EQ(at(1.2, 0.05), StepVerdict::in_step);
}

TEST(Identity, DecidesFromTheOddsAskedAndOnlyWhereSkinIsSeen) {
  Identity identity;
  identity.windows = 200;
  const auto at = [&](double log_ratio) {
    identity.log_likelihood_ratio = log_ratio;
    return identity.verdict();
  };
  // Odds of 100 to 1 (4.6), of which 10 to 1 (2.3) are there before the skin is seen.
  EXPECT_EQ(at(2.4), Identity::Verdict::patient);
  EXPECT_EQ(at(2.2), Identity::Verdict::undecided);
  EXPECT_EQ(at(-6.8), Identity::Verdict::undecided);
  EXPECT_EQ(at(-7.0), Identity::Verdict::other);
  {
    ChangedSettings<IdentityModel> model;
    model->identity_sure = 8;
    EXPECT_EQ(at(4.7), Identity::Verdict::undecided);
  }
  identity.windows = 0;
  EXPECT_FALSE(identity.isAnswered());
  EXPECT_EQ(at(50), Identity::Verdict::undecided) << "nothing in view";
}

}  // namespace
}  // namespace facenav::head_tracking
