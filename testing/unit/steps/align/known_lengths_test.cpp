// Rotation of the right camera, measured by the coil's printed marker in the capture's still pair.

#include "facenav/align/known_lengths.h"

#include <gmock/gmock.h>

#include "facenav/geometry/rotation.h"
#include "support/board_scene.h"
#include "unit/track/coil_tracking/tracked_once.h"

namespace facenav::steps {
namespace {

namespace scene = coil_tracking::testing;

registration::TurnableCamera rightOf(const cameras::StereoRig& rig, const Eigen::Vector3d& at_mm) {
  const Eigen::Vector3d centre_mm = rig.right_T_left.isometry().inverse().translation();
  return {Point<Camera>(centre_mm), Direction<Camera>(at_mm.cross(centre_mm).normalized())};
}

TEST(KnownLengths, TheMarkerShowsHowFarTheRightCameraTurned) {
  const cameras::StereoRig calibrated = scene::roomRig();
  const auto pose = scene::markerPose(600, 20, 30, 10);
  for (const double deg : {-0.8, -0.4, -0.2, 0.0, 0.1, 0.6}) {
    const auto real = testing::turnedRight(calibrated, {0, deg * kRadPerDeg, 0});
    const auto frame = scene::renderMarkers(real, {{scene::id7(), 60, pose}}, {});
    const auto tracker = coil_tracking::makeMarkerCoilTracker();
    const auto length = markerInPair(calibrated, frame, coil_tracking::defaultCoil(), *tracker).length;
    ASSERT_TRUE(length) << deg;
    const auto turn = turnBy(*length, rightOf(calibrated, length->at.mm));
    EXPECT_LT(kDegPerRad * turn.sigma_rad, 0.05);
    EXPECT_NEAR(kDegPerRad * turn.rad, deg, 2.0 * kDegPerRad * turn.sigma_rad) << deg;
  }
}

TEST(KnownLengths, NoMarkerSaysNothing) {
  const cameras::StereoRig rig = scene::roomRig();
  const auto frame = scene::renderMarkers(rig, {}, {});
  const auto tracker = coil_tracking::makeMarkerCoilTracker();
  const auto seen = markerInPair(rig, frame, coil_tracking::defaultCoil(), *tracker);
  EXPECT_FALSE(seen.length);
  EXPECT_FALSE(seen.is_contradicted);
}

TEST(KnownLengths, AMarkerThatFitsNothingIsSaid) {
  const cameras::StereoRig calibrated = scene::roomRig();
  const auto real = testing::turnedRight(calibrated, {0, 4.0 * kRadPerDeg, 0});
  const auto frame = scene::renderMarkers(real, {{scene::id7(), 60, scene::markerPose(600, 20, 30, 10)}}, {});
  const auto tracker = coil_tracking::makeMarkerCoilTracker();
  const auto seen = markerInPair(calibrated, frame, coil_tracking::defaultCoil(), *tracker);
  EXPECT_FALSE(seen.length);
  EXPECT_TRUE(seen.is_contradicted);
}

TEST(KnownLengths, ATurnOfTheWholeRayChangesTheLengthAsItChangesTheDistance) {
  const Eigen::Vector3d at_mm(20, -10, 600);
  const cameras::StereoRig rig = scene::roomRig();
  const auto right = rightOf(rig, at_mm);
  const double rad = 0.001, nearer = 1.0 + rad * right.displacement(at_mm).dot(at_mm) / at_mm.squaredNorm();
  const auto turn = turnBy({Point<Camera>(at_mm), nearer, 0.001}, right);
  EXPECT_NEAR(turn.rad, rad, 1e-9);
}

/// Frame of the marker while it moves sideways; the right camera exposes `late_s` after the left one.
cameras::StereoFrame movingMarker(const cameras::StereoRig& rig, double t_s, double speed_mm_s,
                                  double late_s) {
  const auto at = [&](double time_s) {
    return RigidTransform<Camera, Marker>::fromIsometry(Eigen::Translation3d(speed_mm_s * time_s, 0, 0) *
                                                        scene::markerPose(600, 20, 30, 10).isometry());
  };
  auto frame = scene::renderMarkers(rig, {{scene::id7(), 60, at(t_s)}}, {});
  frame.right = scene::renderMarkers(rig, {{scene::id7(), 60, at(t_s + late_s)}}, {}).right;
  frame.captured = {t_s};
  return frame;
}

TEST(RestingMarker, IsMeasuredWhileItRestsAlone) {
  const cameras::StereoRig rig = scene::roomRig();
  for (const double speed_mm_s : {0.0, 40.0}) {
    const auto tracker = coil_tracking::makeMarkerCoilTracker();
    RestingMarker marker(rig, coil_tracking::defaultCoil(), *tracker);
    for (int i = 0; i < 12; ++i) marker.add(movingMarker(rig, i / 30.0, speed_mm_s, 0.009));
    EXPECT_TRUE(marker.isSeen());
    const auto length = marker.length();
    ASSERT_EQ(length.has_value(), speed_mm_s == 0) << speed_mm_s;
    if (!length) continue;
    EXPECT_GT(marker.rested_s(), 0.25);
    EXPECT_NEAR(length->ratio, 1.0, 2 * length->sigma);
    EXPECT_NEAR(length->at.mm.z(), 600, 5);
  }
}

TEST(RestingMarker, OnePairOfCamerasThatAreNotInStepSaysNothing) {
  const cameras::StereoRig rig = scene::roomRig();
  const auto tracker = coil_tracking::makeMarkerCoilTracker();
  auto frame = movingMarker(rig, 0, 0, 0);
  EXPECT_TRUE(markerInPair(rig, frame, coil_tracking::defaultCoil(), *tracker).length);
  frame.right_late_s = 0.009;
  EXPECT_FALSE(markerInPair(rig, frame, coil_tracking::defaultCoil(), *tracker).length);
}

}  // namespace
}  // namespace facenav::steps
