// Views chosen from real boards before real cameras (shared data): the rig against one that was made from all
// views of three cameras together, and a camera that lags.

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>

#include "facenav/geometry/rigid_fit.h"
#include "facenav/setup/board_collector.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const cameras::Board kRealBoard{9, 6, 10.0};

std::vector<fs::path> picturesOf(const std::string& set, const std::string& camera) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(testing::sharedData() / "real_faces" / set))
    if (entry.path().filename().string().rfind(camera + "_", 0) == 0) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

BoardCollector chosenFrom(const std::string& set, const std::string& left, const std::string& right) {
  BoardCollector collector(kRealBoard, {1024, 1024}, BoardRules());
  const auto lefts = picturesOf(set, left), rights = picturesOf(set, right);
  for (std::size_t i = 0; i < lefts.size(); ++i)
    collector.addStill({lefts[i].filename().string(), cv::imread(lefts[i].string(), cv::IMREAD_GRAYSCALE),
                        cv::imread(rights[i].string(), cv::IMREAD_GRAYSCALE)});
  return collector;
}

/// Difference between a head's points as one rig sees them and the other measures them: as they are, and in
/// shape.
std::pair<double, double> headDifference_mm(const cameras::StereoRig& seen,
                                            const cameras::StereoRig& measured) {
  std::vector<Eigen::Vector3d> truth, found;
  for (const double x : {-70.0, 0.0, 70.0})
    for (const double y : {-90.0, 0.0, 90.0})
      for (const double z : {520.0, 600.0}) {
        const Eigen::Vector3d p(x, y, z);
        truth.push_back(p);
        found.push_back(cameras::triangulate(measured, cameras::project(seen.left, p),
                                             cameras::project(seen.right, seen.right_T_left.isometry() * p))
                            .mm);
      }
  double apart = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    apart += (found[i] - truth[i]).norm() / double(truth.size());
  }
  return {apart, fitRigidPoints(truth, found).rms_mm};
}

class RealBoards : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(testing::sharedData() / "real_faces/boards_2")) GTEST_SKIP() << "no shared data here";
  }
};

TEST_F(RealBoards, ChosenViewsGiveARigNearTheSharedOne) {
  for (const auto& [left, right] : {std::pair("l", "m"), std::pair("m", "r")}) {
    const auto collector = chosenFrom("boards_2", left, right);
    TaskMonitor monitor;
    const auto result = collector.calibrate(monitor);
    const auto shared =
        cameras::readRig(testing::sharedData() / "real_faces" / (std::string(left) + right + "_stereo.yml"));
    const auto [apart_mm, shape_mm] = headDifference_mm(shared, result.rig);
    const auto effect = cameras::effectAtHead(result.rig, {0, 0, 560});
    std::printf(
        "%s%s: %zu views of 20, %.3f px, baseline %.2f mm (%.2f), a head differs by %.2f mm (stated "
        "%.2f), its shape by %.2f mm (stated %.2f of 100 mm)\n",
        left, right, collector.views().size(), result.rms_px, result.rig.baseline_mm(), shared.baseline_mm(),
        apart_mm, effect.point_mm, shape_mm, effect.length_mm);
    EXPECT_LT(result.rms_px, 0.3);
    EXPECT_NEAR(result.rig.baseline_mm(), shared.baseline_mm(), 2.0);
    // Within the error that the calibration gives.
    EXPECT_LT(apart_mm, 3 * effect.point_mm);
    EXPECT_LT(shape_mm, 3 * 1.8 * effect.length_mm) << "a head is 180 mm high; stated are 100 mm";
  }
}

TEST_F(RealBoards, RealBoardsPassTheRulesOfBlurAndLight) {
  std::vector<double> edges_px;
  const BoardRules rules;
  for (const auto& file : picturesOf("boards_2", "m")) {
    const cv::Mat image = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
    const auto seen = cameras::findBoardAtOnce(image, kRealBoard);
    if (seen.px.empty()) continue;
    const auto quality = cameras::boardQuality(image, seen, kRealBoard);
    edges_px.push_back(quality.edge_px);
    EXPECT_GT(quality.white_grey - quality.black_grey, rules.least_contrast) << file;
    EXPECT_LT(quality.white_grey, rules.most_white) << file;
  }
  ASSERT_GE(edges_px.size(), 15u) << "boards found at once, of 20";
  std::sort(edges_px.begin(), edges_px.end());
  std::printf("%zu boards, edges of %.2f to %.2f px\n", edges_px.size(), edges_px.front(), edges_px.back());
  EXPECT_LT(edges_px.back(), rules.most_edge_px);
}

TEST_F(RealBoards, ACameraThatLagsIsNamed) {
  const auto collector = chosenFrom("boards_1", "l", "m");
  TaskMonitor monitor;
  std::string words;
  try {
    const auto result = collector.calibrate(monitor);
    for (const auto& warning : result.warnings) words += warning + "\n";
    for (const auto& view : result.views)
      if (!view.is_used) words += view.name + ": " + view.reason + "\n";
  } catch (const Error& error) {
    words = error.what();
  }
  std::printf("%s", words.c_str());
  EXPECT_THAT(words, HasSubstr("were not triggered together"));
  EXPECT_THAT(words, HasSubstr("l_1769.jpg: disagrees"));  // view 13, counted from 0
  EXPECT_THAT(words, HasSubstr("l_2313.jpg: disagrees"));  // view 17
}

}  // namespace
}  // namespace facenav::steps
