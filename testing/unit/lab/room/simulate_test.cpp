#include "facenav/room/simulate.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "facenav/capture/recording.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/room/synthetic_source.h"
#include "played_scenario.h"
#include "support/frame_source_contract.h"
#include "support/matchers.h"
#include "support/test_data.h"

namespace facenav::room {
namespace {

TEST(SyntheticSource, KeepsTheContractOfFrameSources) {
  const auto patient = testing::eggPatient();
  testing::expectFrameSourceContract(
      [&] { return std::make_unique<SyntheticSource>(testing::smallScenario("treatment", 4), patient); });
}

TEST(SyntheticSource, AnotherSeedGivesOtherImages) {
  const auto patient = testing::eggPatient();
  auto other = testing::smallScenario("free_motion", 2);
  other.seed = 2;
  SyntheticSource a(testing::smallScenario("free_motion", 2), patient), b(other, patient);
  EXPECT_GT(cv::norm(a.next()->left, b.next()->left, cv::NORM_INF), 0.0);
}

/// A view is rendered once until something moves; no part of an earlier moment may stay in the images.
TEST(SyntheticSource, ImagesDoNotDependOnWhatWasRenderedBefore) {
  const auto patient = testing::eggPatient();
  const auto isSame = [](const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF) == 0.0; };
  for (const char* name : {"still", "treatment"}) {
    auto options = testing::smallScenario(name, 3);
    options.right_late_ms = 7;
    SyntheticSource fresh(options, patient), used(options, patient);
    const auto capture = fresh.capturePair();
    const auto first = used.next();
    const auto depth = used.depth();
    const auto later = used.capturePair();
    EXPECT_TRUE(isSame(capture.plain.left, later.plain.left) &&
                isSame(capture.plain.right, later.plain.right));
    EXPECT_TRUE(isSame(capture.pattern.left, later.pattern.left)) << name;
    const auto after = fresh.next();
    EXPECT_TRUE(isSame(first->left, after->left) && isSame(first->right, after->right)) << name;
    EXPECT_TRUE(isSame(depth.left_mm, fresh.depth().left_mm)) << name;
    EXPECT_FALSE(isSame(used.next()->left, first->left)) << name << ": noise of its own, and motion";
  }
}

TEST(SyntheticSource, DepthAgreesWithTheTruePose) {
  const auto patient = testing::eggPatient();
  SyntheticSource source(testing::smallScenario("free_motion", 3), patient);
  while (source.next()) {
    const DepthMaps depth = source.depth();
    const auto mri_T_camera = source.truth().camera_T_mri.inverse();
    double worst_mm = 0.0;
    for (int y = 0; y < depth.left_mm.rows; y += 3)
      for (int x = 0; x < depth.left_mm.cols; x += 3) {
        if (depth.left_object.at<std::uint8_t>(y, x) != 1) continue;
        const Eigen::Vector2d ray = cameras::undistort(source.rig().left, {double(x), double(y)});
        const Eigen::Vector3d p_mri =
            (mri_T_camera * Point<Camera>(depth.left_mm.at<float>(y, x) * ray.homogeneous())).mm;
        // The egg with its hair: between 0 and 5 mm outside the ellipsoid, as a scale of its radii.
        const double scale = (p_mri - Eigen::Vector3d(2.0, 5.0, -10.0))
                                 .cwiseQuotient(Eigen::Vector3d(75.0, 95.0, 110.0))
                                 .norm();
        worst_mm = std::max({worst_mm, (0.999 - scale) * 95.0, (scale - 1.0) * 75.0 - 5.01});
      }
    EXPECT_LE(worst_mm, 0.0);
  }
}

TEST(SyntheticSource, SaysWhenTheHeadCannotBeKnown) {
  SyntheticSource source(testing::smallScenario("lost", 60), testing::eggPatient());
  std::map<std::string, int> lost, seen;
  while (source.next()) ++(source.truth().must_be_lost ? lost : seen)[source.truth().label];
  EXPECT_EQ(lost.count("face in view"), 0u);
  for (const char* label :
       {"both cameras black", "left camera black", "cameras frozen", "left and right swapped"}) {
    EXPECT_GT(lost[label], 0) << label;
    EXPECT_EQ(seen.count(label), 0u) << label;
  }
  for (const char* label : {"head turns away and back", "head leaves the view and returns"})
    EXPECT_GT(lost[label], 0) << label;
}

TEST(SyntheticSource, FrozenCamerasRepeatAndBlackOnesAreBlack) {
  SyntheticSource source(testing::smallScenario("lost", 60), testing::eggPatient());
  std::shared_ptr<const cameras::StereoFrame> last;
  while (const auto frame = source.next()) {
    if (source.truth().label == "cameras frozen") {
      EXPECT_EQ(cv::norm(frame->left, last->left, cv::NORM_INF), 0.0);
    }
    if (source.truth().label == "both cameras black") {
      EXPECT_LT(cv::mean(frame->left)[0], 3.0);
    }
    last = frame;
  }
}

TEST(SyntheticSource, OcclusionHidesPartOfTheFaceAndShowsItAgain) {
  SyntheticSource source(testing::smallScenario("occlusion", 40), testing::eggPatient());
  double least = 1.0, first = -1.0;
  while (source.next()) {
    if (first < 0.0) first = source.truth().face_visible_fraction;
    least = std::min(least, source.truth().face_visible_fraction);
  }
  EXPECT_LT(least, 0.8 * first);
  EXPECT_GT(least, 0.35 * first);
}

TEST(Simulate, WritesARecordingWhoseTruthEndsOnTheTarget) {
  const testing::TemporaryFolder folder;
  const auto patient = testing::eggPatient();
  const auto target = leftHandArea(*patient, 4.0);
  TaskMonitor monitor;
  simulate(testing::smallScenario("treatment", 6), patient, target, folder.path() / "r", monitor);
  const auto recording = capture::openRecording(folder.path() / "r");
  EXPECT_EQ(recording.frame_count, 6);
  EXPECT_TRUE(recording.capture.has_value());
  const auto head = capture::readTruth(folder.path() / "r/truth/head.csv"),
             coil = capture::readTruth(folder.path() / "r/truth/coil.csv");
  ASSERT_EQ(head.size(), 6u);
  ASSERT_EQ(coil.size(), 6u);
  const auto json = nlohmann::json::parse(readWholeFile(folder.path() / "r/coil.json"));
  Eigen::Matrix4d marker_T_coil;
  for (int i = 0; i < 16; ++i)
    marker_T_coil(i / 4, i % 4) = json["marker_T_coil"][std::size_t(i)].get<double>();
  const Eigen::Matrix4d mri_T_coil = head.at(5).inverse().matrix() * coil.at(5).matrix() * marker_T_coil;
  EXPECT_LT((mri_T_coil - target.matrix()).cwiseAbs().maxCoeff(), 1e-4)
      << "coil.json, truth and target agree";
  const auto scenario = nlohmann::json::parse(readWholeFile(folder.path() / "r/scenario.json"));
  EXPECT_EQ(scenario["frames"].size(), 6u);
}

TEST(Simulate, ASecondCoilHasItsOwnMarkerFileAndTruth) {
  const testing::TemporaryFolder folder;
  auto options = testing::smallScenario("treatment", 3);
  options.coils = 2;
  TaskMonitor monitor;
  simulate(options, testing::eggPatient(), {}, folder.path() / "r", monitor);
  const auto head = capture::readTruth(folder.path() / "r/truth/head.csv"),
             coil = capture::readTruth(folder.path() / "r/truth/coil2.csv");
  ASSERT_EQ(coil.size(), 3u);
  const auto json = nlohmann::json::parse(readWholeFile(folder.path() / "r/coil2.json"));
  EXPECT_EQ(json["marker"]["id"], 8);
  EXPECT_EQ(json["name"], "figure-8 70 mm B");
  const auto scenario = nlohmann::json::parse(readWholeFile(folder.path() / "r/scenario.json"));
  Eigen::Matrix4d marker_T_coil, mri_T_target;
  for (int i = 0; i < 16; ++i) {
    marker_T_coil(i / 4, i % 4) = json["marker_T_coil"][std::size_t(i)].get<double>();
    mri_T_target(i / 4, i % 4) = scenario["mri_T_second_target"][std::size_t(i)].get<double>();
  }
  const Eigen::Matrix4d mri_T_coil = head.at(2).inverse().matrix() * coil.at(2).matrix() * marker_T_coil;
  EXPECT_LT((mri_T_coil - mri_T_target).cwiseAbs().maxCoeff(), 1e-4);
  EXPECT_GT(mri_T_target(0, 3), 0) << "on the right side; the first one is on the left";
  EXPECT_NEAR(Eigen::Matrix3d(mri_T_target.block(0, 0, 3, 3)).determinant(), 1, 1e-6);
}

TEST(Simulate, CancelledLeavesNothingBehind) {
  const testing::TemporaryFolder folder;
  TaskMonitor* handle = nullptr;
  TaskMonitor monitor([&](const std::string&, double fraction) {
    if (fraction > 0.4) handle->cancel();
  });
  handle = &monitor;
  EXPECT_THROW(
      simulate(testing::smallScenario("still", 6), testing::eggPatient(), {}, folder.path() / "r", monitor),
      Cancelled);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace facenav::room
