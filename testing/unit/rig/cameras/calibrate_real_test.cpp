// Real data: the 13 chessboard pairs of Debian's opencv-doc, and boards before three real cameras, one of
// which exposes late.

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>

#include "facenav/cameras/calibrate.h"
#include "facenav/core/error.h"
#include "facenav/core/parallel_for.h"
#include "support/test_data.h"

using namespace facenav;
using namespace facenav::cameras;
using ::testing::HasSubstr;

namespace {

std::filesystem::path boards(const std::string& set) {
  return facenav::testing::sharedData() / "real_faces" / set;
}

const Board kBoard{9, 6, 10.0};
const cv::Size kImage(1024, 1024);

/// Images that show only a part of the board: a useless search takes a second or two each.
const std::set<std::string> kCutOff = {
    "boards_1/l_2177", "boards_1/r_0545", "boards_1/r_0681", "boards_1/r_0817", "boards_1/r_1905",
    "boards_1/r_2585", "boards_2/r_1331", "boards_2/r_1464", "boards_2/r_1597", "boards_2/r_1730"};

/// Corners in each image of one camera of a set, found once for all tests. Key: the name after the camera's
/// letter ("_0001.jpg").
const std::map<std::string, SeenCorners>& cornersOf(const std::string& set, char camera) {
  static std::map<std::pair<std::string, char>, std::map<std::string, SeenCorners>> known;
  auto& corners = known[{set, camera}];
  if (!corners.empty()) return corners;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(boards(set)))
    if (entry.path().filename().string().front() == camera &&
        kCutOff.count(set + "/" + entry.path().stem().string()) == 0)
      files.push_back(entry.path());
  std::vector<SeenCorners> seen(files.size());
  parallelRanges(0, int(files.size()), [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      seen[std::size_t(i)] =
          findBoard(cv::imread(files[std::size_t(i)].string(), cv::IMREAD_GRAYSCALE), kBoard);
  });
  for (std::size_t i = 0; i < files.size(); ++i) corners[files[i].filename().string().substr(1)] = seen[i];
  return corners;
}

/// Calibrates from pairs of the cameras `left` and `right` ('l', 'm', 'r').
Calibration calibratedFrom(const std::string& set, char left, char right) {
  std::vector<BoardView> views;
  const auto& others = cornersOf(set, right);
  for (const auto& [name, seen] : cornersOf(set, left)) {
    const auto other = others.find(name);
    if (other == others.end() || seen.px.empty() || other->second.px.empty()) continue;
    views.push_back({left + name, seen.px, other->second.px, seen.ids, other->second.ids});
  }
  TaskMonitor monitor;
  return calibrateCorners(views, kImage, kBoard, monitor);
}

const ViewReport& viewOf(const Calibration& calibration, const std::string& name) {
  return *std::find_if(calibration.views.begin(), calibration.views.end(),
                       [&](const auto& view) { return view.name == name; });
}

}  // namespace

TEST(CalibrateRealData, ALaggingCameraIsNamedAndNoAnglesAreAskedFor) {
  FACENAV_NEEDS(boards("boards_1"));
  const Calibration result = calibratedFrom("boards_1", 'l', 'm');
  for (const char* name : {"l_1769.jpg", "l_2313.jpg"}) {  // by 2.7 px
    EXPECT_FALSE(viewOf(result, name).is_used) << name;
    EXPECT_THAT(viewOf(result, name).reason, HasSubstr("not simultaneous, the board moved")) << name;
  }
  EXPECT_THAT(result.warnings, ::testing::Contains(HasSubstr("not triggered together")));
  EXPECT_THAT(result.warnings, ::testing::Each(::testing::Not(HasSubstr("angles"))));
}

TEST(CalibrateRealData, ALaggingCameraThatLeavesTooFewViewsIsRefusedForThatReason) {
  FACENAV_NEEDS(boards("boards_1"));
  try {
    calibratedFrom("boards_1", 'l', 'r');
    FAIL() << "a rig was made of a lagging camera";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("not triggered together"));
    EXPECT_THAT(error.what(), HasSubstr("trigger both cameras"));
  }
}

TEST(CalibrateRealData, TwoCalibrationsOfOneCameraDifferByWhatTheyState) {
  FACENAV_NEEDS(boards("boards_1"));
  FACENAV_NEEDS(boards("boards_2"));
  const Calibration first = calibratedFrom("boards_1", 'm', 'r'),
                    second = calibratedFrom("boards_2", 'm', 'r');
  ASSERT_EQ(first.parameters.size(), second.parameters.size());
  for (const Calibration* one : {&first, &second})
    EXPECT_THAT(one->warnings, ::testing::Each(::testing::Not(HasSubstr("exposures"))));
  double squares = 0;
  for (std::size_t i = 0; i < first.parameters.size(); ++i) {
    const auto &a = first.parameters[i], &b = second.parameters[i];
    const double z = (a.value - b.value) / std::hypot(a.sigma, b.sigma);
    EXPECT_LT(std::abs(z), 3.0) << a.name << " " << a.value << " and " << b.value;
    squares += z * z;
  }
  EXPECT_LT(std::sqrt(squares / double(first.parameters.size())), 1.5);
}

TEST(CalibrateRealData, ThirteenOpenCvPairsReachAQuarterPixel) {
  const auto folder = facenav::testing::openCvSamples();
  FACENAV_NEEDS(folder / "left01.jpg");
  std::vector<CalibrationPair> pairs;
  for (int i = 1; i <= 14; ++i) {
    char name[16];
    std::snprintf(name, sizeof name, "%02d.jpg", i);
    if (!std::filesystem::exists(folder / (std::string("left") + name))) continue;  // there is no 10
    pairs.push_back({name, cv::imread(folder / (std::string("left") + name), cv::IMREAD_GRAYSCALE),
                     cv::imread(folder / (std::string("right") + name), cv::IMREAD_GRAYSCALE)});
  }
  ASSERT_EQ(pairs.size(), 13u);
  TaskMonitor monitor;
  const Calibration result = calibrate(pairs, {9, 6, 25.0}, monitor);
  EXPECT_EQ(result.usedViews(), 13);
  EXPECT_LE(result.rms_px, 0.25);
  EXPECT_LE(result.held_out_rms_px, 0.25);
  EXPECT_NEAR(result.rig.left.k(0, 0), 534, 5);  // as in intrinsics.yml of the same package, 5.36e2
  EXPECT_GT(result.rig.right_T_left.inverse().translation_mm().x(), 0);
}
