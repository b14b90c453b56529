// Hand-made runs with known errors, and the verdicts on the goals.

#include <gmock/gmock.h>

#include "facenav/evaluation/cloud_evaluation.h"
#include "facenav/evaluation/error_statistics.h"
#include "facenav/evaluation/evaluation_report.h"
#include "facenav/evaluation/frame_errors.h"
#include "facenav/evaluation/goals.h"
#include "facenav/evaluation/run_table.h"
#include "made_runs.h"
#include "support/test_data.h"

namespace facenav::evaluation {
namespace {

using made::perfectRun;
using made::shifted;
using ::testing::HasSubstr;

GoalRow goalNamed(const std::vector<GoalRow>& rows, const std::string& start) {
  for (const auto& row : rows)
    if (row.quantity.rfind(start, 0) == 0) return row;
  ADD_FAILURE() << "no goal called " << start;
  return {};
}

TEST(FrameErrors, TellTheMotionFromTheAlignment) {
  RunRecord run = perfectRun("protractor", 2);
  run.alignment->estimated = shifted(0.4, 0, 600);
  run.frames[1].head_motion = shifted(0, 0.3, 0);
  const auto errors = frameErrors(run);
  EXPECT_NEAR(errors[0].motion->mm, 0.0, 1e-12);
  EXPECT_NEAR(errors[0].head->mm, 0.4, 1e-12);
  EXPECT_NEAR(errors[1].motion->mm, 0.3, 1e-12);
  EXPECT_NEAR(errors[1].head->mm, 0.5, 1e-12);
}

TEST(FrameErrors, APoseWithoutThePatientIsWrong) {
  RunRecord run = perfectRun("other_face", 2);
  run.frames[1].truth.head.reset();
  const auto errors = frameErrors(run);
  EXPECT_FALSE(errors[0].is_head_wrong);
  EXPECT_TRUE(errors[1].is_head_wrong);
  EXPECT_EQ(goalNamed(judge({run}), "wrong poses").verdict, Verdict::missed);
}

TEST(Goals, AReturnThatIsNeverFoundCountsAgainstTheGoal) {
  RunRecord run = perfectRun("grimace", 40);
  for (std::size_t i = 5; i < 20; ++i) {
    run.frames[i].truth.must_be_lost = i < 7;
    run.frames[i].head_motion.reset();
  }
  run.frames[20].truth.must_be_lost = true;
  run.frames[20].head_motion.reset();
  const auto row = goalNamed(judge({run}), "back with another grimace");
  EXPECT_EQ(row.measured, "1 of 2");
  EXPECT_EQ(row.verdict, Verdict::missed);
}

TEST(Goals, MomentsOfARealFaceHaveTheirOwnRow) {
  RunRecord run = perfectRun("moments", 40);
  for (std::size_t i = 5; i < 10; ++i) {
    run.frames[i].truth.must_be_lost = i < 7;
    run.frames[i].head_motion.reset();
  }
  EXPECT_EQ(goalNamed(judge({run}), "back as a real face").measured, "1 of 1");
  EXPECT_EQ(goalNamed(judge({run}), "back with another grimace").verdict, Verdict::not_measured);
}

TEST(Goals, APoseWhileTheCamerasAreOutOfStepIsCounted) {
  RunRecord run = perfectRun("out_of_step", 4);
  run.frames[2].truth.must_be_lost = run.frames[3].truth.must_be_lost = true;
  run.frames[3].head_motion.reset();
  EXPECT_EQ(goalNamed(judge({run}), "a pose shown while").measured, "1 of 2 frames");
}

TEST(FrameErrors, CoilAgainstHeadDoesNotSeeWhatBothShare) {
  RunRecord run = perfectRun("treatment", 1);
  run.target_mm = {10, 20, 30};
  run.frames[0].truth.marker = shifted(50, 0, 560);
  run.frames[0].marker = shifted(50.2, 0, 560);
  run.frames[0].head_motion = shifted(0.2, 0, 0);
  const auto errors = frameErrors(run);
  EXPECT_NEAR(errors[0].coil->mm, 0.2, 1e-12);
  EXPECT_NEAR(errors[0].motion->mm, 0.2, 1e-12);
  EXPECT_NEAR(errors[0].relative->mm, 0.0, 1e-12);
}

TEST(Losses, AreCountedWhereTheHeadCouldBeKnown) {
  RunRecord run = perfectRun("lost", 60);
  for (int i = 10; i < 22; ++i) run.frames[i].head_motion.reset();  // 12 frames without a reason
  for (int i = 30; i < 50; ++i) run.frames[i].head_motion.reset();
  for (int i = 30; i < 44; ++i) run.frames[i].truth.must_be_lost = true;  // visible from 44, tracked from 50
  EXPECT_NEAR(longestLoss_s(run), 12 / 60.0, 1e-12);
  const auto again_s = timesToFindAgain_s(run);
  ASSERT_EQ(again_s.size(), 1u);
  EXPECT_NEAR(again_s[0], 6 / 60.0, 1e-12);
}

TEST(Losses, AHeadThatIsNeverFoundAgainCountsToTheEnd) {
  RunRecord run = perfectRun("lost", 60);
  for (int i = 20; i < 60; ++i) run.frames[i].head_motion.reset();
  for (int i = 20; i < 30; ++i) run.frames[i].truth.must_be_lost = true;
  EXPECT_THAT(timesToFindAgain_s(run), ::testing::ElementsAre(::testing::DoubleNear(30 / 60.0, 1e-12)));
}

TEST(Jitter, IsTheSpreadAboutTheMean) {
  RunRecord run = perfectRun("still", 4);
  for (int i = 0; i < 4; ++i) run.frames[i].head_motion = shifted(5.0 + (i % 2 ? 0.1 : -0.1));
  EXPECT_NEAR(jitter_mm(run), 0.1 * std::sqrt(4.0 / 3.0), 1e-12);
}

TEST(Goals, WhatNoRunSpeaksToIsNotMet) {
  for (const auto& row : judge({})) EXPECT_EQ(row.verdict, Verdict::not_measured) << row.quantity;
}

TEST(Goals, AreMetByAPerfectRunAndMissedByABadOne) {
  RunRecord run = perfectRun("protractor", 30);
  EXPECT_EQ(goalNamed(judge({run}), "head motion since alignment, at the target: protractor").verdict,
            Verdict::met);
  EXPECT_EQ(goalNamed(judge({run}), "head motion since alignment, at the target: free").verdict,
            Verdict::not_measured);
  for (int i = 0; i < 3; ++i) run.frames[i].head_motion = shifted(0.9);  // rms 0.28, but p95 0.9 mm
  EXPECT_EQ(goalNamed(judge({run}), "head motion since alignment, at the target: protractor").verdict,
            Verdict::missed);
}

TEST(Goals, ARefusedCaptureIsAMiss) {
  RunRecord run = perfectRun("capture", 0);
  EXPECT_EQ(goalNamed(judge({run}), "alignment at the cortical target, development").verdict, Verdict::met);
  RunRecord refused = run;
  refused.alignment->refusal = "not aligned: too little face";
  EXPECT_EQ(goalNamed(judge({run, refused}), "alignment at the cortical target, development").verdict,
            Verdict::missed);
}

TEST(Goals, ARepeatedCaptureCountsOnce) {
  RunRecord run = perfectRun("capture", 0), again = perfectRun("still", 3);
  run.alignment->estimated = shifted(0.3, 0, 600);
  again.is_capture_repeated = true;
  EXPECT_EQ(goalNamed(judge({run, again}), "alignment at the cortical target, development").basis,
            "1 captures");
}

TEST(Goals, StatedBoundsAreCheckedAgainstTheTruth) {
  std::vector<RunRecord> runs(20, perfectRun("capture", 0));
  for (auto& run : runs) run.alignment->bound95_mm = 0.5;
  runs[0].alignment->estimated = shifted(0.6, 0, 600);
  EXPECT_EQ(goalNamed(judge(runs), "alignment: true error").verdict, Verdict::met);  // 19 of 20
  runs[1].alignment->estimated = shifted(0.6, 0, 600);
  EXPECT_EQ(goalNamed(judge(runs), "alignment: true error").verdict, Verdict::missed);
}

TEST(RunTable, HasOneLineARunAndLeavesUnknownFiguresEmpty) {
  RunRecord run = perfectRun("still", 3);
  run.failure = "a \"quoted\" word, and more";
  const std::string csv = runsCsv({run});
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2);
  EXPECT_THAT(csv, HasSubstr("\"a 'quoted' word, and more\""));
  EXPECT_EQ(csv.find("nan"), std::string::npos);
}

TEST(Quantile, IsTheSmallestValueWithThatShareBelow) {
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0.5), 2);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0.99), 4);
  EXPECT_EQ(quantile({}, 0.5), 0);
}

TEST(EvaluationReport, WritesItsFilesAndNoScript) {
  const testing::TemporaryFolder folder;
  writeEvaluation({perfectRun("protractor", 5), perfectRun("still", 5)}, "two runs", folder.path());
  for (const char* file : {"report.html", "evaluation.csv", "evaluation.md", "motion.svg", "time.svg"})
    EXPECT_TRUE(std::filesystem::exists(folder.path() / file)) << file;
}

/// Two cameras in front of a plane at 600 mm.
struct Plane {
  cameras::StereoRig rig;
  ExactDepth depth;
  Plane() {
    rig.width_px = 160;
    rig.height_px = 120;
    rig.left.k = rig.right.k = cv::Matx33d(200, 0, 80, 0, 200, 60, 0, 0, 1);
    rig.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(shifted(-60));
    depth.left_mm = depth.right_mm = cv::Mat(120, 160, CV_32F, cv::Scalar(600.f));
    depth.is_head_left = cv::Mat(120, 160, CV_8U, cv::Scalar(255));
  }
};

TEST(CloudEvaluation, MeasuresTheErrorAlongTheRayAndTheCoverage) {
  const Plane plane;
  const cv::Mat visible = visibleFace(plane.rig, plane.depth, Point<Camera>(30, 0, 600), 60.0);
  const int pixels = cv::countNonZero(visible);
  EXPECT_NEAR(pixels, M_PI * 20 * 20, 60) << "a disc of 60 mm is 20 px here";
  stereo::FaceCloud face;  // every second row, 0.3 mm too far
  for (int y = 0; y < 120; y += 2)
    for (int x = 0; x < 160; ++x) {
      const Eigen::Vector3d ray((x - 80) / 200.0, (y - 60) / 200.0, 1.0);
      face.cloud.points_mm.push_back((600.0 + 0.3 / ray.norm()) * ray);
      face.left_px.push_back({float(x), float(y)});
      face.sigma_mm.push_back(0.2f);
    }
  const auto all = evaluateCloud(plane.rig, face, plane.depth, visible);
  EXPECT_NEAR(all.rms_mm, 0.3, 1e-4);
  EXPECT_NEAR(all.predicted_mm, 0.2, 1e-4);
  EXPECT_NEAR(all.coverage_percent, 100.0, 3.0) << "rows between two covered ones count";
  EXPECT_EQ(all.gross_percent, 0.0);
  face.cloud.points_mm.resize(face.cloud.size() / 2);  // the upper half only
  const auto half = evaluateCloud(plane.rig, face, plane.depth, visible);
  EXPECT_NEAR(half.coverage_percent, 50.0, 5.0);
}

/// The upper half of the face has one error, the lower one another.
TEST(CloudEvaluation, SaysWhatNeighboursShare) {
  const Plane plane;
  const auto measured = [&](double upper_mm, double lower_mm) {
    stereo::FaceCloud face;
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 160; ++x) {
        const Eigen::Vector3d ray((x - 80) / 200.0, (y - 60) / 200.0, 1.0);
        face.cloud.points_mm.push_back((600.0 + (y < 60 ? upper_mm : lower_mm) / ray.norm()) * ray);
        face.left_px.push_back({float(x), float(y)});
        face.sigma_mm.push_back(0.2f);
      }
    const cv::Mat visible = visibleFace(plane.rig, plane.depth, Point<Camera>(0, 0, 600), 60.0);
    return evaluateCloud(plane.rig, face, plane.depth, visible);
  };
  const auto near = measured(-0.5, -0.5);
  EXPECT_NEAR(near.mean_mm, -0.5, 1e-3);
  for (const double shared : near.shared_mm2) EXPECT_NEAR(shared, 0.25, 1e-3);
  const auto tilted = measured(-0.5, 0.5);
  EXPECT_NEAR(tilted.mean_mm, 0.0, 0.05);
  EXPECT_GT(tilted.shared_mm2.front(), 0.12) << "near neighbours err alike";
  EXPECT_LT(tilted.shared_mm2.back(), -0.08) << "far ones oppositely";
}

}  // namespace
}  // namespace facenav::evaluation
