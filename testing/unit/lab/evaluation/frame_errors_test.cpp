// Figures of single frames and runs, from given errors.

#include "facenav/evaluation/frame_errors.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "facenav/evaluation/error_statistics.h"
#include "facenav/evaluation/run_table.h"
#include "facenav/evaluation/tracking_evaluation.h"
#include "made_runs.h"

namespace facenav::evaluation {
namespace {

using made::perfectRun;
using made::shifted;
using made::turned;
using ::testing::DoubleNear;
using ::testing::ElementsAre;

TEST(Quantile, KeepsItsDefinitionForEveryCount) {
  for (const double fraction : {0.5, 0.9, 0.95, 0.99})
    for (int n = 1; n <= 200; ++n) {
      std::vector<double> values(n);
      for (int i = 0; i < n; ++i) values[i] = i;
      std::shuffle(values.begin(), values.end(), std::mt19937(n));
      const double q = quantile(values, fraction);
      // Whole numbers: at or below q lie q + 1 values; below q lie q.
      EXPECT_GE((q + 1) / n, fraction - 1e-12) << n;
      EXPECT_LT(q / n, fraction) << n << ": a smaller one would not do";
    }
}

TEST(Quantile, OfAllIsTheLargestAndOfNoneTheSmallest) {
  EXPECT_EQ(quantile({3, -1, 7}, 1.0), 7);
  EXPECT_EQ(quantile({3, -1, 7}, 0.0), -1);
  EXPECT_EQ(quantile({5}, 0.95), 5);
}

TEST(ErrorStatistics, Percentile95LeavesOneOfTwentyAbove) {
  std::vector<double> errors(20, 1.0);
  errors[7] = 50.0;
  EXPECT_EQ(summarise(errors).p95, 1.0);
  errors[8] = 40.0;
  EXPECT_EQ(summarise(errors).p95, 40.0);
  EXPECT_EQ(summarise(errors).max, 50.0);
}

TEST(ErrorStatistics, DoesNotDependOnTheOrderAndScalesWithTheUnit) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal(0.5, 2.0);
  std::vector<double> errors;
  for (int i = 0; i < 101; ++i) errors.push_back(std::abs(normal(random)));
  const auto one = summarise(errors);
  for (double& e : errors) e *= 1000;
  std::reverse(errors.begin(), errors.end());
  const auto other = summarise(errors);
  EXPECT_NEAR(other.rms, 1000 * one.rms, 1e-9);
  EXPECT_NEAR(other.median, 1000 * one.median, 1e-9);
  EXPECT_NEAR(other.p95, 1000 * one.p95, 1e-9);
  EXPECT_GE(one.rms, one.mean);
  EXPECT_LE(one.median, one.p95);
}

TEST(FrameErrors, APoseIsWrongBeyondThreeMillimetresOrTwoDegrees) {
  const auto isWrong = [](const Eigen::Isometry3d& error) {
    RunRecord run = perfectRun("still", 1);
    run.frames[0].head_motion = error;
    return frameErrors(run)[0].is_head_wrong;
  };
  EXPECT_FALSE(isWrong(shifted(0, 2.999, 0)));
  EXPECT_TRUE(isWrong(shifted(0, 3.001, 0)));
  const auto turnedAtTarget = [](double deg) {  // about an axis through the target: no shift there
    return shifted(0, 0, 600) * turned(deg, Eigen::Vector3d::UnitX()) * shifted(0, 0, -600);
  };
  EXPECT_FALSE(isWrong(turnedAtTarget(1.999)));
  EXPECT_TRUE(isWrong(turnedAtTarget(2.001)));
}

TEST(FrameErrors, AWrongAlignmentMakesAPoseWrongAlthoughTheMotionIsRight) {
  RunRecord run = perfectRun("still", 1);
  run.alignment->estimated = shifted(3.5, 0, 600);
  const auto errors = frameErrors(run)[0];
  EXPECT_NEAR(errors.motion->mm, 0, 1e-12);
  EXPECT_TRUE(errors.is_head_wrong);
  run.alignment->refusal = "not aligned";
  EXPECT_FALSE(frameErrors(run)[0].is_head_wrong) << "a refused alignment was never shown";
}

TEST(FrameErrors, ARotationCountsAtTheTargetByItsLever) {
  RunRecord run = perfectRun("still", 1);
  run.target_mm = {0, 80, 0};  // 80 mm from Mri's origin, about which the pose is turned
  run.frames[0].head_motion =
      shifted(0, 0, 600) * turned(1.0, Eigen::Vector3d::UnitZ()) * shifted(0, 0, -600);
  const auto motion = *frameErrors(run)[0].motion;
  EXPECT_NEAR(motion.mm, 2 * 80 * std::sin(0.5 * M_PI / 180), 1e-9);
  EXPECT_NEAR(motion.deg, 1.0, 1e-9);
}

TEST(FrameErrors, ALostHeadHasNoError) {
  RunRecord run = perfectRun("still", 1);
  run.frames[0].head_motion.reset();
  const auto errors = frameErrors(run)[0];
  EXPECT_FALSE(errors.motion || errors.head || errors.relative);
  EXPECT_FALSE(errors.is_head_wrong);
}

TEST(FrameErrors, ACoilThatIsNotThereIsWrong) {
  RunRecord run = perfectRun("still", 2);
  run.frames[0].marker = shifted(0, 0, 500);
  const auto errors = frameErrors(run);
  EXPECT_TRUE(errors[0].is_coil_wrong);
  EXPECT_FALSE(errors[0].coil);
  EXPECT_FALSE(errors[1].is_coil_wrong);
}

TEST(FrameErrors, DistanceAndTiltAreThoseOfTheTrueMarker) {
  RunRecord run = perfectRun("coil_sweep", 1);
  made::addCoil(run, shifted(300, 0, 400) * turned(0, Eigen::Vector3d::UnitX()));
  auto errors = frameErrors(run)[0];
  EXPECT_NEAR(errors.coil_distance_mm, 500, 1e-9);
  EXPECT_NEAR(errors.coil_tilt_deg, std::atan2(300, 400) * 180 / M_PI, 1e-9)
      << "its z is parallel to the camera's, the line of sight is not";
  made::addCoil(run, shifted(0, 0, 650) * turned(35, Eigen::Vector3d::UnitY()));
  errors = frameErrors(run)[0];
  EXPECT_NEAR(errors.coil_tilt_deg, 35, 1e-9);
  run.frames[0].marker = shifted(0, 0, 100);  // what was tracked does not change it
  EXPECT_NEAR(frameErrors(run)[0].coil_distance_mm, 650, 1e-9);
}

TEST(FrameErrors, TheCoilOnTheHeadHasTheErrorsOfBoth) {
  RunRecord run = perfectRun("treatment", 1);
  made::addCoil(run, shifted(0, 0, 500));
  run.frames[0].marker = shifted(0.3, 0, 500);
  run.frames[0].head_motion = shifted(0, 0.4, 0);
  auto errors = frameErrors(run)[0];
  EXPECT_NEAR(errors.relative->mm, 0.5, 1e-9);
  EXPECT_NEAR(errors.relative_motion->mm, 0.5, 1e-9);
  run.alignment->estimated = shifted(0.3, 0.4, 600);  // with the alignment's error in x: only y's 0.8 is left
  errors = frameErrors(run)[0];
  EXPECT_NEAR(errors.relative->mm, 0.8, 1e-9);
  EXPECT_NEAR(errors.relative_motion->mm, 0.5, 1e-9);
}

TEST(FrameErrors, WhatIsMovedTogetherWithTheWholeRoomIsTheSame) {
  RunRecord run = perfectRun("treatment", 1), moved = run;
  made::addCoil(run, shifted(20, 10, 500));
  run.frames[0].marker = shifted(20.2, 10, 500.1) * turned(0.3, Eigen::Vector3d::UnitY());
  moved = run;
  const Eigen::Isometry3d room = shifted(5, -7, 30) * turned(20, Eigen::Vector3d(1, 1, 0).normalized());
  auto& frame = moved.frames[0];
  frame.truth.head = room * *frame.truth.head;
  frame.truth.marker = room * *frame.truth.marker;
  frame.marker = room * *frame.marker;
  frame.head_motion = room * *frame.head_motion;
  const auto a = frameErrors(run)[0], b = frameErrors(moved)[0];
  EXPECT_NEAR(a.relative->mm, b.relative->mm, 1e-9);
  EXPECT_NEAR(a.relative->deg, b.relative->deg, 1e-6);
  EXPECT_NEAR(a.head->mm, b.head->mm, 1e-9);
  EXPECT_NEAR(a.coil->mm, b.coil->mm, 1e-9);
}

TEST(Losses, TimesFollowTheFrameRate) {
  for (const double rate : {30.0, 60.0, 120.0}) {
    RunRecord run = perfectRun("lost", 40);
    run.frames_per_s = rate;
    for (int i = 8; i < 20; ++i) run.frames[i].head_motion.reset();
    for (int i = 8; i < 14; ++i) run.frames[i].truth.must_be_lost = true;
    EXPECT_THAT(timesToFindAgain_s(run), ElementsAre(DoubleNear(6 / rate, 1e-12)));
    EXPECT_NEAR(longestLoss_s(run), 6 / rate, 1e-12) << "the unknowable frames do not count";
  }
}

TEST(Losses, AHeadThatIsBackAtOnceWaitedNoTime) {
  RunRecord run = perfectRun("lost", 30);
  for (int i = 10; i < 20; ++i) run.frames[i].head_motion.reset(), run.frames[i].truth.must_be_lost = true;
  EXPECT_THAT(timesToFindAgain_s(run), ElementsAre(0.0));
  EXPECT_EQ(longestLoss_s(run), 0.0);
}

TEST(Losses, TheClockStartsWhenHalfOfTheFaceIsSeen) {
  RunRecord run = perfectRun("lost", 40);
  for (auto& frame : run.frames) frame.truth.face_visible_fraction = 0.8;
  for (int i = 10; i < 25; ++i) run.frames[i].head_motion.reset();
  for (int i = 10; i < 15; ++i) run.frames[i].truth.must_be_lost = true;
  for (int i = 15; i < 20; ++i)
    run.frames[i].truth.face_visible_fraction = 0.39;  // just below the half of 0.8
  EXPECT_THAT(timesToFindAgain_s(run), ElementsAre(DoubleNear(5 / 60.0, 1e-12)));
  for (int i = 15; i < 20; ++i) run.frames[i].truth.face_visible_fraction = 0.41;
  EXPECT_THAT(timesToFindAgain_s(run), ElementsAre(DoubleNear(10 / 60.0, 1e-12)));
}

TEST(Losses, AnAbsentPatientIsNoLossOfTracking) {
  RunRecord run = perfectRun("other_face", 30);
  for (int i = 5; i < 25; ++i) run.frames[i].head_motion.reset(), run.frames[i].truth.head.reset();
  EXPECT_EQ(longestLoss_s(run), 0.0);
  EXPECT_THAT(timesToFindAgain_s(run), ElementsAre(0.0));
}

TEST(Losses, OfARunWithoutFramesAreNone) {
  EXPECT_TRUE(timesToFindAgain_s(perfectRun("lost", 0)).empty());
  EXPECT_EQ(longestLoss_s(perfectRun("lost", 0)), 0.0);
}

TEST(Jitter, IgnoresWhereTheHeadIsAndLostFrames) {
  RunRecord run = perfectRun("still", 6);
  for (int i = 0; i < 6; ++i) run.frames[i].head_motion = shifted(0, i % 2 ? 0.2 : -0.2, 0);
  const double here = jitter_mm(run);
  for (auto& frame : run.frames) frame.head_motion = shifted(40, 0, 7) * *frame.head_motion;
  EXPECT_NEAR(jitter_mm(run), here, 1e-9);
  run.frames[0].head_motion.reset();
  run.frames[1].head_motion.reset();
  EXPECT_NEAR(jitter_mm(run), 0.2 * std::sqrt(4.0 / 3.0), 1e-9);
  for (int i = 1; i < 6; ++i) run.frames[i].head_motion.reset();
  EXPECT_EQ(jitter_mm(run), 0.0);
}

TEST(TrackingEvaluation, SeparatesFramesWithoutTruthFromLostOnes) {
  const std::map<std::int64_t, Eigen::Isometry3d> truth{{0, shifted(0)}, {2, shifted(0)}};
  const auto result = evaluateTracking(
      {{0, true, shifted(1)}, {1, true, shifted(99)}, {2, false, shifted(50)}}, truth, {0, 0, 0});
  EXPECT_EQ(result.frames, 3);
  EXPECT_EQ(result.tracked, 2);
  EXPECT_EQ(result.lost, 1);
  ASSERT_EQ(result.errors.size(), 1u);
  EXPECT_EQ(result.wrong_as_tracked, 0) << "without a truth nothing is said";
  EXPECT_NEAR(result.errors[0].shift_mm.x(), 1.0, 1e-12) << "estimate minus truth";
}

TEST(TrackingEvaluation, CountsBothLimitsOfAWrongPose) {
  const std::map<std::int64_t, Eigen::Isometry3d> truth{{0, shifted(0)}};
  const auto wrong = [&](const Eigen::Isometry3d& pose) {
    return evaluateTracking({{0, true, pose}}, truth, {0, 0, 0}).wrong_as_tracked;
  };
  EXPECT_EQ(wrong(shifted(0, 0, -2.99)), 0);
  EXPECT_EQ(wrong(shifted(0, 0, -3.01)), 1);
  EXPECT_EQ(wrong(turned(1.99, Eigen::Vector3d::UnitY())), 0);
  EXPECT_EQ(wrong(turned(-2.01, Eigen::Vector3d::UnitY())), 1);
}

double figure(const RunRecord& run, const std::string& wanted) {
  for (const auto& [name, value] : figuresOf(run))
    if (name == wanted) return value;
  ADD_FAILURE() << "no figure " << wanted;
  return 0;
}

TEST(Figures, CountWhatTheirNamesSay) {
  RunRecord run = perfectRun("coil_sweep", 10);
  made::addCoil(run, shifted(0, 0, 500));
  for (int i = 0; i < 4; ++i) run.frames[i].is_marker_in_view = true;
  run.frames[3].marker.reset();
  run.frames[9].marker.reset();
  run.frames[5].head_motion = shifted(10);
  run.frames[6].head_motion.reset();
  run.frames[7].truth.must_be_lost = true;
  run.frames[8].truth.head.reset();
  EXPECT_EQ(figure(run, "frames"), 10);
  EXPECT_EQ(figure(run, "frames_head_knowable"), 8);
  EXPECT_EQ(figure(run, "frames_head_tracked"), 9);
  EXPECT_EQ(figure(run, "frames_marker_in_view"), 4);
  EXPECT_EQ(figure(run, "frames_marker_in_view_tracked"), 3);
  EXPECT_EQ(figure(run, "frames_coil_tracked"), 8);
  EXPECT_EQ(figure(run, "head_wrong_as_tracked"), 2) << "10 mm off, and one without a patient";
  EXPECT_EQ(figure(run, "coil_wrong_as_tracked"), 0);
  EXPECT_NEAR(figure(run, "longest_loss_s"), 1 / 60.0, 1e-12);
  EXPECT_NEAR(figure(run, "motion_max_mm"), 10, 1e-9);
  EXPECT_TRUE(std::isnan(figure(run, "cloud_rms_mm")));
  EXPECT_TRUE(std::isnan(figure(run, "jitter_mm"))) << "of a still head only";
}

TEST(Figures, HaveTheSameNamesForEveryRun) {
  RunRecord full = perfectRun("still", 3);
  full.cloud.emplace();
  const auto a = figuresOf(full), b = figuresOf(RunRecord{});
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].first, b[i].first);
}

}  // namespace
}  // namespace facenav::evaluation
