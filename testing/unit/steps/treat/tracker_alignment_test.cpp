#include "facenav/treat/tracker_alignment.h"

#include <gmock/gmock.h>

#include <fstream>

#include "facenav/core/error.h"
#include "facenav/guidance/target.h"
#include "support/ball_case.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;

RigidTransform<Mri, Head> truth() {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, -2, 0.5).normalized())),
          {12, -140, 35}};
}

/// Places on the ball of 90 mm: nasion, both tragi, vertex.
const std::vector<std::pair<std::string, Eigen::Vector3d>> kPlaces{{"nasion", {0, 90, 0}},
                                                                   {"left tragus", {-90, 0, 0}},
                                                                   {"right tragus", {90, 0, 0}},
                                                                   {"vertex", {0, 0, 90}}};

std::vector<TouchedPoint> touchedPoints(std::size_t count) {
  std::vector<TouchedPoint> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({kPlaces[i].first, Point<Mri>(kPlaces[i].second),
                      (truth().inverse() * Point<Mri>(kPlaces[i].second)).mm});
  return points;
}

class TrackerAlignmentFile : public ::testing::Test {
 protected:
  TrackerAlignment read(const std::string& json) const {
    std::ofstream(file_) << json;
    return readTrackerAlignment(file_);
  }
  std::string refused(const std::string& json) const {
    try {
      read(json);
    } catch (const Error& error) {
      return error.what();
    }
    return "taken";
  }
  /// `noise_mm`: error of the points; `map`: what happened to the tracker's coordinates.
  static std::string points(std::size_t count, double noise_mm, const Eigen::Matrix3d& map,
                            const std::string& error = "2") {
    std::string list;
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [name, p] = kPlaces[i];
      Eigen::Vector3d s = map * (truth().inverse() * Point<Mri>(p)).mm;
      s[int(i) % 3] += noise_mm;
      list += std::string(i ? "," : "") + "{\"name\":\"" + name + "\",\"mri_mm\":[" + std::to_string(p.x()) +
              "," + std::to_string(p.y()) + "," + std::to_string(p.z()) + "],\"subject_mm\":[" +
              std::to_string(s.x()) + "," + std::to_string(s.y()) + "," + std::to_string(s.z()) + "]}";
    }
    return "{\"error_mm\":" + error + ",\"points\":[" + list + "]}";
  }

  testing::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "alignment.json";
};

const Eigen::Matrix3d kAsIs = Eigen::Matrix3d::Identity();

TEST_F(TrackerAlignmentFile, APoseIsTakenWithItsStatedError) {
  const auto alignment = read(R"({"mri_T_subject": [1,0,0,5, 0,1,0,6, 0,0,1,7, 0,0,0,1], "error_mm": 1.5})");
  EXPECT_EQ(alignment.mri_T_subject.translation_mm(), Eigen::Vector3d(5, 6, 7));
  const auto store = casefile::CaseStore::create(folder_.path() / "case", testing::ballCase(), {}, false);
  const auto outcome = outcomeOf(alignment, store);
  EXPECT_EQ(outcome.result.camera_T_mri.translation_mm(), Eigen::Vector3d(-5, -6, -7));
  guidance::Target target;
  target.cortex_point = Point<Mri>(0, 0, 70);
  target.scalp_point = Point<Mri>(0, 0, 90);
  EXPECT_NEAR(outcome.predictedError_mm(target), 1.5, 0.01);
  EXPECT_NEAR(outcome.errorBound_mm(target), 2.5, 0.3) << "1.6 times as much keeps 95 of 100";
}

TEST_F(TrackerAlignmentFile, TouchedPointsGiveThePoseAndAnErrorThatGrowsWithDistance) {
  const auto exact = read(points(4, 0, kAsIs));
  EXPECT_LT((exact.mri_T_subject.matrix() - truth().matrix()).norm(), 1e-3);
  EXPECT_TRUE(exact.cautions.empty());
  const auto noisy = read(points(4, 1, kAsIs));
  EXPECT_LT((noisy.mri_T_subject.translation_mm() - truth().translation_mm()).norm(), 3);
  AlignmentOutcome outcome;
  outcome.result.camera_T_mri = exact.mri_T_subject.inverse().reframe<Camera, Mri>();
  outcome.result.covariance = exact.covariance;
  const double near_mm = outcome.result.predictedError_mm(Point<Mri>(0, 25, 25)),
               far_mm = outcome.result.predictedError_mm(Point<Mri>(0, -90, 0));
  EXPECT_NEAR(near_mm, 1.0, 0.2) << "2 mm over the root of four points, at their middle";
  EXPECT_GT(far_mm, 1.5 * near_mm);
}

TEST_F(TrackerAlignmentFile, WhatCannotBeRightIsRefused) {
  EXPECT_THAT(refused(R"({"mri_T_subject": [1,0,0,5, 0,1,0,6, 0,0,1,7, 0,0,0,1]})"), HasSubstr("error_mm"));
  EXPECT_NE(refused(R"({"mri_T_subject": [-1,0,0,5, 0,1,0,6, 0,0,1,7, 0,0,0,1], "error_mm": 1})"), "taken");
  EXPECT_NE(refused(R"({"mri_T_subject": [1000,0,0,5, 0,1000,0,6, 0,0,1000,7, 0,0,0,1], "error_mm": 1})"),
            "taken");
  EXPECT_NE(refused(R"({"error_mm": 0, "mri_T_subject": [1,0,0,5, 0,1,0,6, 0,0,1,7, 0,0,0,1]})"), "taken");
  EXPECT_THAT(refused(points(2, 0, kAsIs)), HasSubstr("at least three points"));
  EXPECT_THAT(refused(points(4, 0, Eigen::Vector3d(-1, 1, 1).asDiagonal())), HasSubstr("do not fit"))
      << "mirrored";
  EXPECT_THAT(refused(points(4, 0, 1e-3 * kAsIs)), HasSubstr("do not fit")) << "metres";
  EXPECT_THAT(refused(points(4, 30, kAsIs)), HasSubstr("do not fit"));
}

TEST_F(TrackerAlignmentFile, ThreePointsThatAlsoFitExchangedAreCautioned) {
  const auto alignment = read(points(3, 0, kAsIs));
  EXPECT_LT((alignment.mri_T_subject.matrix() - truth().matrix()).norm(), 1e-3);
  ASSERT_EQ(alignment.cautions.size(), 1u);
  EXPECT_THAT(alignment.cautions.front(), HasSubstr("exchanged"));
}

TEST_F(TrackerAlignmentFile, PointsOfAnotherHeadAreRefused) {
  auto alignment = read(points(4, 0, kAsIs));
  const auto ball = testing::ballCase();
  EXPECT_NO_THROW(requireOnSkin(alignment, ball.scalp));
  alignment.points.front().in_mri = Point<Mri>(0, 140, 0);
  EXPECT_THROW(requireOnSkin(alignment, ball.scalp), Error);
}

TEST_F(TrackerAlignmentFile, TouchedPointsAreWrittenAndReadBack) {
  writeTouchedPoints(touchedPoints(4), 2, file_);
  const auto alignment = readTrackerAlignment(file_);
  EXPECT_LT((alignment.mri_T_subject.matrix() - truth().matrix()).norm(), 1e-6);
  EXPECT_EQ(std::filesystem::status(file_).permissions() & std::filesystem::perms::group_read,
            std::filesystem::perms::none);
  auto exchanged = touchedPoints(4);
  std::swap(exchanged[0].in_subject_mm, exchanged[3].in_subject_mm);
  EXPECT_THROW(writeTouchedPoints(exchanged, 2, file_), Error);
  EXPECT_THROW(writeTouchedPoints(touchedPoints(2), 2, file_), Error);
  EXPECT_EQ(readTrackerAlignment(file_).points.size(), 4u) << "the file before stays";
}

}  // namespace
}  // namespace facenav::steps
