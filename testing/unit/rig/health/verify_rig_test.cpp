// Tests whether a rig still fits: pictures of a board and of the coil's marker, rendered with the calibrated
// rig and with rigs that differ from it by a known amount.

#include "facenav/health/verify_rig.h"

#include <gmock/gmock.h>

#include "facenav/core/error.h"
#include "support/board_scene.h"
#include "unit/track/coil_tracking/tracked_once.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;
namespace scene = coil_tracking::testing;

const cameras::StereoRig& calibration() {
  static const cameras::StereoRig rig = scene::roomRig();
  return rig;
}

health::SquareFinder markerFinder() {
  return coil_tracking::squareFinder(coil_tracking::makeMarkerCoilTracker(), calibration(),
                                     coil_tracking::defaultCoil());
}

health::RigVerification verifiedByBoard(const cameras::StereoRig& real, bool is_swapped = false,
                                        double square_mm = testing::kPrintedBoard.square_mm, int places = 3) {
  auto board = testing::kPrintedBoard;
  board.square_mm = square_mm;
  health::RigVerifier verifier(calibration(), board, nullptr);
  for (int i = 0; i < places; ++i) {
    auto frame = testing::boardFrame(real, i);
    if (is_swapped) std::swap(frame.left, frame.right);
    verifier.add(frame);
  }
  return verifier.result();
}

health::RigVerification verifiedByMarker(const cameras::StereoRig& real) {
  health::RigVerifier verifier(calibration(), std::nullopt, markerFinder());
  for (int i = 0; i < 8; ++i) {
    scene::SceneOptions options;
    options.seed = unsigned(i + 1);
    const auto pose = scene::markerPose(560 + 60 * (i / 4), 25, 40, 10, {50.0 * (i / 4) - 25, 20});
    auto frame = scene::renderMarkers(real, {{scene::id7(), 60, pose}}, options);
    frame.number = i;
    frame.captured = {i / 30.0};
    verifier.add(frame);
  }
  return verifier.result();
}

TEST(VerifyRig, ARigThatHoldsIsSaidToHoldWithItsNumbers) {
  const auto result = verifiedByBoard(calibration());
  EXPECT_EQ(result.state, health::RigState::holds) << result.words();
  EXPECT_EQ(result.board_frames, 3);
  ASSERT_EQ(result.lengths.size(), 1u);
  EXPECT_NEAR(result.lengths[0].measured_mm, 160.0, 0.15);
  EXPECT_LT(result.row_error_px, 0.1);
  EXPECT_LT(result.left_lens_px, 0.15);
  EXPECT_THAT(result.findings()[1], HasSubstr("160.00 mm true"));
}

TEST(VerifyRig, SaysHowFarTheBoardMovedBetweenTheMeasurements) {
  const auto result = verifiedByBoard(calibration());
  // Pose as by boardFrame(); the board's middle lies 30 mm above that of the print.
  const auto first = scene::markerPose(600, 20, 10, 0, {-15, 20}),
             last = scene::markerPose(660, 15, 220, 10, {15, 4}),
             second = scene::markerPose(560, 30, 100, 5, {0, 12});
  const Point<Marker> middle(0, -30, 0);
  const double moved_mm = std::max(((last * middle).mm - (first * middle).mm).norm(),
                                   ((second * middle).mm - (first * middle).mm).norm());
  const auto turned_deg = [&](const auto& pose) {
    return std::acos(pose.rotation().col(2).dot(first.rotation().col(2))) * kDegPerRad;
  };
  EXPECT_NEAR(result.motion.moved_mm, moved_mm, 3);
  EXPECT_NEAR(result.motion.turned_deg, std::max(turned_deg(last), turned_deg(second)), 1.5);
  EXPECT_TRUE(result.motion.isEnough());
  EXPECT_THAT(result.words(), HasSubstr("deg between the measurements"));
  EXPECT_FALSE((health::CheckMotion{60, 5}.isEnough()));
  EXPECT_TRUE((health::CheckMotion{110, 5}.isEnough()));
  EXPECT_THAT((health::CheckMotion{60, 5}.words()),
              HasSubstr("moved only 60 mm between the measurements: move it by 100"));
  const health::MeasuredLength length{"board", 160.0, 160.4, 0.3};
  EXPECT_THAT(length.words(), HasSubstr("160.40 mm measured, 160.00 mm true: +0.40 mm, +0.25 %"));
}

TEST(VerifyRig, ACameraThatTurnedSidewaysShowsInTheLength) {
  const auto result = verifiedByBoard(testing::turnedRight(calibration(), {0, 0.3 * kRadPerDeg, 0}));
  EXPECT_EQ(result.state, health::RigState::moved) << result.words();
  EXPECT_LT(result.row_error_px, 1.0);  // rows alone would not show it
  EXPECT_GT(std::abs(result.lengths[0].measured_mm - 160.0), 1.5);
  EXPECT_THAT(result.words(), HasSubstr("instead of 160.00 mm"));
}

TEST(VerifyRig, AWrongSizeOfTheSquaresIsToldFromATurnedCamera) {
  const auto wrong = verifiedByBoard(calibration(), false, 25.0);  // printed: 20 mm
  EXPECT_EQ(wrong.state, health::RigState::moved) << wrong.words();
  ASSERT_TRUE(wrong.square_doubt) << wrong.words();
  EXPECT_NEAR(wrong.square_doubt->fitting_mm, 20.0, 0.05);
  EXPECT_THAT(wrong.words(), HasSubstr("the rows fit, but the length does not"));
  EXPECT_THAT(wrong.words(), HasSubstr("not 25.00 mm; measure one"));
  // At one distance, a turned camera looks the same: both are said.
  const auto at_one = verifiedByBoard(calibration(), false, 25.0, 1);
  EXPECT_THAT(at_one.words(), HasSubstr("check the size of a square first (25.00 mm is given, 20.0"));
  const auto turned = verifiedByBoard(testing::turnedRight(calibration(), {0, 0.3 * kRadPerDeg, 0}));
  EXPECT_FALSE(turned.square_doubt) << turned.words();
  EXPECT_THAT(turned.words(), HasSubstr("calibrate again"));
}

TEST(VerifyRig, ACameraThatNoddedShowsInTheRowsWithItsAngle) {
  const auto result = verifiedByBoard(testing::turnedRight(calibration(), {0.15 * kRadPerDeg, 0, 0}));
  EXPECT_EQ(result.state, health::RigState::moved) << result.words();
  EXPECT_NEAR(result.turn_deg, 0.15, 0.05);
  const auto gross = verifiedByBoard(testing::turnedRight(calibration(), {1.0 * kRadPerDeg, 0, 0}));
  EXPECT_EQ(gross.state, health::RigState::moved) << gross.words();
  EXPECT_NEAR(gross.turn_deg, 1.0, 0.2);
}

TEST(VerifyRig, AnotherLensIsNamedWithItsSide) {
  auto other = calibration();
  other.right.distortion = other.right.distortion.clone();
  other.right.distortion.at<double>(0) -= 1.5;
  const auto result = verifiedByBoard(other);
  EXPECT_EQ(result.state, health::RigState::other_cameras) << result.words();
  EXPECT_THAT(result.words(), HasSubstr("the right camera's pictures do not fit its lens"));
}

TEST(VerifyRig, AFocusThatWasChangedIsNoTurnedCamera) {
  auto other = calibration();
  other.right.k(0, 0) *= 1.02;
  other.right.k(1, 1) *= 1.02;
  const auto result = verifiedByBoard(other);
  EXPECT_EQ(result.state, health::RigState::other_cameras) << result.words();
  EXPECT_NEAR(result.scale_change, 0.02, 0.003);
  const auto turned = verifiedByBoard(testing::turnedRight(calibration(), {0, 1.0 * kRadPerDeg, 0}));
  EXPECT_EQ(turned.state, health::RigState::moved) << turned.words();
  EXPECT_LT(std::abs(turned.scale_change), 0.003);
}

TEST(VerifyRig, ExchangedSidesAreSaid) {
  const auto result = verifiedByBoard(calibration(), true);
  EXPECT_EQ(result.state, health::RigState::swapped) << result.words();
}

TEST(VerifyRig, TheCoilsMarkerTellsTheSame) {
  const auto holds = verifiedByMarker(calibration());
  EXPECT_EQ(holds.state, health::RigState::holds) << holds.words();
  ASSERT_EQ(holds.lengths.size(), 1u);
  EXPECT_NEAR(holds.lengths[0].measured_mm, 60.0, 0.1);
  const auto turned = verifiedByMarker(testing::turnedRight(calibration(), {0, 0.5 * kRadPerDeg, 0}));
  EXPECT_EQ(turned.state, health::RigState::moved) << turned.words();
  const auto nodded = verifiedByMarker(testing::turnedRight(calibration(), {0.15 * kRadPerDeg, 0, 0}));
  EXPECT_EQ(nodded.state, health::RigState::moved) << nodded.words();
}

TEST(VerifyRig, WithoutBoardAndMarkerNothingIsClaimed) {
  health::RigVerifier verifier(calibration(), testing::kPrintedBoard, markerFinder());
  verifier.add(scene::renderMarkers(calibration(), {}));
  EXPECT_EQ(verifier.result().state, health::RigState::unclear);
  EXPECT_THAT(verifier.result().words(), HasSubstr("neither board nor marker"));
  cameras::StereoFrame small;
  small.left = small.right = cv::Mat::zeros(240, 320, CV_8U);
  EXPECT_THROW(verifier.add(small), Error);
}

}  // namespace
}  // namespace facenav::steps
