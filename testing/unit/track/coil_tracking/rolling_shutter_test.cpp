#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "facenav/geometry/pose_error.h"
#include "support/matchers.h"
#include "tracked_once.h"

namespace facenav::coil_tracking {
namespace {
using namespace testing;
using facenav::testing::PoseNear;

constexpr double kFrames_per_s = 30.0;
const Eigen::Vector3d kSwing_mm_s(180, -60, 120);  // 224 mm/s

cameras::StereoRig rollingRig(double row_time_s) {
  cameras::StereoRig rig = roomRig();
  rig.left.row_time_s = rig.right.row_time_s = row_time_s;
  return rig;
}

/// Pose low in the picture, where rows are read some milliseconds after the middle one.
RigidTransform<Camera, Marker> swungTo(double t_s) {
  auto pose = markerPose(600, 20, 70, 10, {-40, 110}).isometry();
  pose.translation() += t_s * kSwing_mm_s;
  return RigidTransform<Camera, Marker>::fromIsometry(pose);
}

cameras::StereoFrame swungFrame(const cameras::StereoRig& rig, int i) {
  SceneOptions options;
  options.seed = unsigned(i + 1);
  const double t_s = i / kFrames_per_s;
  PlacedPrint print{id7(), 60, swungTo(t_s)};
  print.moving_mm_s = kSwing_mm_s;
  auto frame = renderMarkers(rig, {print}, options);
  frame.captured.s = t_s;
  return frame;
}

/// Largest error from the third frame on, when the velocity is known, mm. Cameras of `truth` film; the
/// tracker gets `stated`. Infinite if the coil is lost.
double worstError_mm(const cameras::StereoRig& truth, const cameras::StereoRig& stated) {
  const auto tracker = makeMarkerCoilTracker();
  tracker->start(stated, defaultCoil());
  double worst_mm = 0.0;
  for (int i = 0; i < 9; ++i) {
    const auto pose = tracker->track(swungFrame(truth, i));
    if (i < 3) continue;
    if (!pose) return std::numeric_limits<double>::infinity();
    worst_mm =
        std::max(worst_mm, poseError(pose->camera_T_marker, swungTo(i / kFrames_per_s)).translation_mm);
  }
  return worst_mm;
}

TEST(RollingShutter, TheRowTimePutsASwungCoilWhereItIsInTheMiddleRowsMoment) {
  const auto rolling = rollingRig(42e-6);  // 20 ms a picture
  EXPECT_LT(worstError_mm(rolling, rolling), 0.3);
  EXPECT_GT(worstError_mm(rolling, rollingRig(0)),
            0.9);  // error without knowing the row time
}

TEST(RollingShutter, ACameraThatReadsFromBelowHasANegativeRowTime) {
  const auto rolling = rollingRig(-42e-6);
  EXPECT_LT(worstError_mm(rolling, rolling), 0.3);
}

TEST(RollingShutter, CamerasOfDifferentKindShareNoRowTime) {
  auto rig = rollingRig(42e-6);
  rig.right.row_time_s = 15e-6;  // 7 ms a picture; without it the same rows are 5 ms apart
  EXPECT_LT(worstError_mm(rig, rig), 0.4);
}

TEST(RollingShutter, TheRowTimeDoesNotMoveAStillCoil) {
  const auto rig = roomRig(), stated = rollingRig(42e-6);
  const auto pose_of = [](const cameras::StereoRig& as_stated, const cameras::StereoFrame& frame) {
    const auto tracker = makeMarkerCoilTracker();
    tracker->start(as_stated, defaultCoil());
    auto again = frame;
    again.captured.s = 1.0 / kFrames_per_s;
    tracker->track(frame);
    return tracker->track(again)->camera_T_marker;
  };
  const auto frame = renderMarkers(rig, {{id7(), 60, swungTo(0)}});
  EXPECT_THAT(pose_of(stated, frame), PoseNear(pose_of(rig, frame), 1e-6, 1e-6));
}

/// Print waved to and fro in front of the cameras, as a hand does: at up to 250 mm/s.
PlacedPrint waved(double t_s) {
  const Eigen::Vector3d reach_mm(30, 22, 25), turn_rad_s(2 * M_PI * 1.2, 2 * M_PI * 0.9, 2 * M_PI * 0.7);
  auto pose = markerPose(600, 20, 70, 10, {-40, 60}).isometry();
  PlacedPrint print{id7(), 60, {}};
  for (int axis = 0; axis < 3; ++axis) {
    pose.translation()[axis] += reach_mm[axis] * std::sin(turn_rad_s[axis] * t_s);
    print.moving_mm_s[axis] = reach_mm[axis] * turn_rad_s[axis] * std::cos(turn_rad_s[axis] * t_s);
  }
  print.camera_T_marker = RigidTransform<Camera, Marker>::fromIsometry(pose);
  return print;
}

/// Root mean square error from 1 s to 2 s, mm. Infinite if the coil is lost then.
double errorOfWaving_mm(const cameras::StereoRig& truth, const cameras::StereoRig& stated,
                        double late_s = 0.0, int known_from = 0) {
  const auto tracker = makeMarkerCoilTracker();
  tracker->start(stated, defaultCoil());
  double squares = 0.0;
  int count = 0;
  for (int i = 0; i < 60; ++i) {
    SceneOptions options;
    options.seed = unsigned(i + 1);
    const PlacedPrint print = waved(i / kFrames_per_s);
    auto frame = renderMarkers(truth, {print}, options);
    if (late_s != 0.0) frame.right = renderMarkers(truth, {waved(i / kFrames_per_s + late_s)}, options).right;
    frame.captured.s = i / kFrames_per_s;
    CoilContext context;
    if (late_s != 0.0 && i >= known_from) context.exposure_offset = {late_s, 3e-4};
    const auto pose = tracker->track(frame, context);
    if (i < 30) continue;  // may be lost: a shear without an explanation may look like a turned camera
    if (!pose) return std::numeric_limits<double>::infinity();
    const double error_mm = poseError(pose->camera_T_marker, print.camera_T_marker).translation_mm;
    squares += error_mm * error_mm;
    ++count;
  }
  return std::sqrt(squares / count);
}

TEST(RollingShutter, IsMeasuredFromAMovingCoilWhereTheRigDoesNotStateIt) {
  EXPECT_LT(errorOfWaving_mm(rollingRig(42e-6), rollingRig(0)), 0.2);
}

TEST(RollingShutter, ADelayThatNobodyStatesDoesNotFalsifyTheRowTimes) {
  const auto truth = rollingRig(42e-6);
  const auto tracker = makeMarkerCoilTracker();
  tracker->start(rollingRig(0), defaultCoil());
  std::array<double, 2> row_times_s{};
  for (int i = 0; i < 60; ++i) {
    SceneOptions options;
    options.seed = unsigned(i + 1);
    auto frame = renderMarkers(truth, {waved(i / kFrames_per_s)}, options);
    frame.right = renderMarkers(truth, {waved(i / kFrames_per_s + 0.009)}, options).right;
    frame.captured.s = i / kFrames_per_s;
    row_times_s = tracker->track(frame).row_times_s;
  }
  for (const double row_time_s : row_times_s) EXPECT_NEAR(row_time_s, 42e-6, 6e-6);
}

TEST(RollingShutter, IsMeasuredBesideTheDelayOfACameraWithoutTrigger) {
  EXPECT_LT(errorOfWaving_mm(rollingRig(42e-6), rollingRig(0), 0.009), 0.4);
  EXPECT_LT(errorOfWaving_mm(rollingRig(42e-6), rollingRig(0), 0.009, 15), 0.4);
}

TEST(RollingShutter, AStatementThatIsTwiceTheTruthIsCorrected) {
  EXPECT_LT(errorOfWaving_mm(rollingRig(42e-6), rollingRig(84e-6)), 0.2);
}

TEST(RollingShutter, CamerasThatExposeAllRowsAtOnceStayWithoutRowTime) {
  EXPECT_LT(errorOfWaving_mm(rollingRig(0), rollingRig(0)), 0.1);
}

TEST(RollingShutter, APairThatComesAgainUnderANewTimeIsStaleWhileTheCoilMoves) {
  const auto rig = rollingRig(42e-6);
  const auto tracker = makeMarkerCoilTracker();
  tracker->start(rig, defaultCoil());
  for (int i = 0; i < 8; ++i) {
    auto frame = swungFrame(rig, i == 5 ? 4 : i);
    if (i == 5) frame.right = swungFrame(rig, 5).right;  // one picture of the pair is enough
    frame.captured.s = i / kFrames_per_s;
    const auto pose = tracker->track(frame);
    ASSERT_EQ(pose.isTracked(), i != 5) << i;
    if (i == 5) {
      EXPECT_EQ(pose.reason(), LostReason::stale);
    } else if (i > 2) {
      EXPECT_THAT(pose->camera_T_marker, PoseNear(swungTo(i / kFrames_per_s), 0.3, 0.3)) << i;
    }
  }
}

TEST(RollingShutter, ACoilAtRestMayBeShownByTheSamePairTwice) {
  const auto tracker = makeMarkerCoilTracker();
  tracker->start(roomRig(), defaultCoil());
  auto frame = renderMarkers(roomRig(), {{id7(), 60, swungTo(0)}});
  for (int i = 0; i < 4; ++i) {
    frame.captured.s = i / kFrames_per_s;
    EXPECT_TRUE(tracker->track(frame)) << i;
  }
}

}  // namespace
}  // namespace facenav::coil_tracking
