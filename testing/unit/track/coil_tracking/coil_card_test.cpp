#include "facenav/coil_tracking/coil_card.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <opencv2/aruco.hpp>

#include "coil_scene.h"
#include "facenav/coil_tracking/coil_calibration.h"
#include "facenav/coil_tracking/visible_markers.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/test_data.h"

namespace facenav::coil_tracking {
namespace {

using facenav::testing::TemporaryFolder;
using ::testing::HasSubstr;

const char* const kCoilJson = R"({"name": "figure-8", "make": "Acme", "model": "F8", "serial": "12",
  "marker": {"dictionary": "4x4_50", "id": 7, "size_mm": 60}, "marker_T_coil": [1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],
  "contact_outline_mm": [[-90,-50],[90,-50],[90,50],[-90,50]], "focus_mm": [0, 12, 0], "colour": "grey"})";

TEST(CoilCard, HoldsMakerFocusAndCalibrationWithItsDate) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "coil.json", calibrated = folder.path() / "calibrated.json";
  writeWholeFile(file, kCoilJson);
  const CoilCard card = readCoilCard(file);
  EXPECT_EQ(card.make + card.model + card.serial, "AcmeF812");
  EXPECT_EQ(card.focus_mm, Eigen::Vector3d(0, 12, 0));
  EXPECT_FALSE(card.isFocusCentred());
  EXPECT_TRUE(card.has_outline);
  EXPECT_FALSE(card.calibration);

  CoilCalibration calibration;
  calibration.method = "jig", calibration.utc = "2026-05-04T10:00:00.000Z";
  calibration.rms_mm = 0.21, calibration.used = 42;
  calibration.marker_T_coil = {Eigen::Quaterniond::Identity(), {1, 2, 3}};
  writeCalibratedCoil(readCoil(file), calibration, calibrated, file);
  const CoilCard after = readCoilCard(calibrated);
  ASSERT_TRUE(after.calibration);
  EXPECT_EQ(after.calibration->utc, calibration.utc);
  EXPECT_EQ(after.calibration->frames, 42);
  EXPECT_EQ(after.make, "Acme") << "a calibration loses nothing that was known of the coil";
  EXPECT_TRUE(after.has_outline);
  EXPECT_EQ(readCoil(calibrated).marker_T_coil().translation_mm(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(nlohmann::json::parse(readWholeFile(calibrated))["colour"], "grey");
}

TEST(CoilCard, RefusesAFocusFarFromTheCoil) {
  const TemporaryFolder folder;
  std::string text = kCoilJson;
  text.replace(text.find("[0, 12, 0]"), 10, "[0, 512, 0]");
  writeWholeFile(folder.path() / "coil.json", text);
  try {
    readCoilCard(folder.path() / "coil.json");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("focus_mm"));
  }
}

TEST(CoilCard, TwoCoilsShareAMarkerOnlyWhereThePrintIsTheSame) {
  CoilModel a = defaultCoil(), b = defaultCoil();
  EXPECT_TRUE(shareMarker(a, b));
  b.markers.front().id = 8;
  EXPECT_FALSE(shareMarker(a, b));
  b.markers.push_back(a.markers.front());
  EXPECT_TRUE(shareMarker(a, b));
  b.markers = {a.markers.front()};
  b.markers.front().dictionary = "4x4_100";
  EXPECT_TRUE(shareMarker(a, b)) << "the larger dictionary begins with the same prints";
  b.markers.front().dictionary = "5x5_50";
  EXPECT_FALSE(shareMarker(a, b));
}

TEST(CoilCard, TwoCoilsOfASessionNeedTheirOwnMarkerAndName) {
  CoilModel a = defaultCoil(), b = defaultCoil();
  a.name = "A", b.name = "B";
  EXPECT_THROW(requireTellable(a, b), Error);
  b.markers.front().id = 8;
  EXPECT_NO_THROW(requireTellable(a, b));
  b.name = "A";
  EXPECT_THROW(requireTellable(a, b), Error);
}

TEST(VisibleMarkers, NamesThePrintsThatAPictureShows) {
  using namespace coil_tracking::testing;
  const auto rig = roomRig();
  const auto frame =
      renderMarkers(rig, {{arucoPrint(cv::aruco::DICT_4X4_50, 9), 60, markerPose(600, 20, 30, 10)}});
  EXPECT_EQ(visibleMarkers(frame.left, "4x4_50"), std::set<int>{9});
  EXPECT_EQ(visibleMarkers(frame.right, "4x4_50"), std::set<int>{9});
  EXPECT_TRUE(visibleMarkers(cv::Mat(), "4x4_50").empty());
  EXPECT_THROW(visibleMarkers(frame.left, "5x99"), Error);
}

}  // namespace
}  // namespace facenav::coil_tracking
