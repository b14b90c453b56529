// Objects that must not be taken for the coil, and faults of the cameras.
#include <gtest/gtest.h>

#include "tracked_once.h"

#include "facenav/geometry/rotation.h"

namespace facenav::coil_tracking {
namespace {
using namespace testing;

TEST(CoilTracker, AnotherIdIsNotTaken) {
  for (const int id : {0, 3, 8, 23, 49})
    for (const double turn_deg : {0.0, 90.0, 200.0}) {
      const auto frame = renderMarkers(
          roomRig(), {{arucoPrint(cv::aruco::DICT_4X4_50, id), 60, markerPose(550, 20, 70, turn_deg)}});
      const auto pose = trackOnce(roomRig(), frame);
      ASSERT_FALSE(pose.isTracked()) << "id " << id;
      EXPECT_EQ(pose.reason(), LostReason::no_marker);
    }
}

TEST(CoilTracker, AMirroredPrintIsNotTaken) {
  for (const double turn_deg : {0.0, 90.0, 180.0, 270.0}) {
    const auto frame = renderMarkers(roomRig(), {{mirrored(id7()), 60, markerPose(550, 15, 70, turn_deg)}});
    EXPECT_FALSE(trackOnce(roomRig(), frame).isTracked());
  }
}

TEST(CoilTracker, SwappedImagesAreLost) {
  for (const double distance_mm : {450.0, 600.0, 680.0, 800.0})
    for (const double tilt_deg : {0.0, 30.0}) {
      auto frame =
          renderMarkers(roomRig(), {{id7(), 60, markerPose(distance_mm, tilt_deg, 70, 10, {30, 20})}});
      std::swap(frame.left, frame.right);
      EXPECT_FALSE(trackOnce(roomRig(), frame).isTracked()) << distance_mm << " mm, " << tilt_deg << " deg";
    }
}

TEST(CoilTracker, AMovedCameraIsLost) {
  auto moved = roomRig();
  const auto frame = renderMarkers(moved, {{id7(), 60, markerPose(600, 20, 70, 10)}});
  Eigen::Isometry3d pose = moved.right_T_left.isometry();
  pose.prerotate(
      Eigen::AngleAxisd(0.4 * kRadPerDeg, Eigen::Vector3d::UnitX()));  // 5 px across the epipolar lines
  moved.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(pose);
  const auto lost = trackOnce(moved, frame);
  ASSERT_FALSE(lost.isTracked());
  EXPECT_EQ(lost.reason(), LostReason::camera);
}

/// Returns true if the coil is tracked although the right camera's true pose differs by 0.06 deg about `axis`
/// from the assumed one, with this given error.
bool isTrackedBeside(const Eigen::Vector3d& axis, double sigma_deg) {
  const auto real = roomRig();
  const auto frame = renderMarkers(real, {{id7(), 60, markerPose(600, 20, 70, 10)}});
  auto lagging = real;
  Eigen::Isometry3d pose = real.right_T_left.isometry();
  pose.prerotate(Eigen::AngleAxisd(0.06 * kRadPerDeg, axis));
  lagging.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(pose);
  const auto tracker = makeMarkerCoilTracker();
  tracker->start(lagging, defaultCoil());
  CoilContext context;
  context.right_turn_sigma_rad = sigma_deg * kRadPerDeg;
  return tracker->track(frame, context).isTracked();
}

TEST(CoilTracker, ACameraThatIsFollowedMayNodByItsStatedErrorAndNotTurnSideways) {
  const Eigen::Vector3d nod = Eigen::Vector3d::UnitX(), sideways = Eigen::Vector3d::UnitY();
  EXPECT_FALSE(isTrackedBeside(nod, 0.0));
  EXPECT_TRUE(isTrackedBeside(nod, 0.04));
  EXPECT_FALSE(isTrackedBeside(sideways, 0.0));
  EXPECT_FALSE(isTrackedBeside(sideways, 0.04)) << "a wrong size is a wrong depth";
}

TEST(CoilTracker, OneImageAloneIsNotEnough) {
  for (const bool is_left : {true, false}) {
    auto frame = renderMarkers(roomRig(), {{id7(), 60, markerPose(600, 20, 70, 10)}});
    const auto empty = renderMarkers(roomRig(), {});
    (is_left ? frame.right : frame.left) = is_left ? empty.right : empty.left;
    const auto lost = trackOnce(roomRig(), frame);
    ASSERT_FALSE(lost.isTracked());
    EXPECT_EQ(lost.reason(), LostReason::no_marker);
  }
}

TEST(CoilTracker, BlackOrWrongImagesAreTheCamerasFault) {
  const auto rig = roomRig();
  const auto good = renderMarkers(rig, {{id7(), 60, markerPose(600, 20, 70, 10)}});
  auto black = good, small = good;
  black.right = cv::Mat::zeros(good.right.size(), CV_8U);
  small.left = good.left(cv::Rect(0, 0, 320, 240));
  for (const auto& frame : {black, small, cameras::StereoFrame{}}) {
    const auto lost = trackOnce(rig, frame);
    ASSERT_FALSE(lost.isTracked());
    EXPECT_EQ(lost.reason(), LostReason::camera);
  }
}

TEST(CoilTracker, TheMarkerTwiceIsLostRatherThanGuessed) {
  const auto frame = renderMarkers(roomRig(), {{id7(), 60, markerPose(600, 15, 70, 10, {-60, 0})},
                                               {id7(), 60, markerPose(600, 15, 70, 10, {60, 0})}});
  EXPECT_FALSE(trackOnce(roomRig(), frame).isTracked());
}

TEST(CoilTracker, ClutterAloneIsNeverAMarker) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SceneOptions options;
    options.seed = seed;
    EXPECT_FALSE(trackOnce(roomRig(), renderMarkers(roomRig(), {}, options)).isTracked());
  }
}

}  // namespace
}  // namespace facenav::coil_tracking
