// A lost face is found again, wherever it is, within the work budget of a frame.

#include "head_scene.h"

namespace facenav {
namespace {

using namespace head_tracking::testing;
using testing::SyntheticFace;
using testing::SyntheticView;

TEST_F(HeadTrackers, AFaceLostIsFoundAgainElsewhereAtOnce) {
  const auto tracker = head_tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  ASSERT_TRUE(tracker->track(face_->render(rig_, viewAt(0, 10))).isTracked());
  SyntheticView hidden = viewAt(1, 10);
  hidden.cover_mm = cv::Rect2d(-200, -200, 400, 400);
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(tracker->track(face_->render(rig_, hidden)).isTracked());
  const SyntheticView back = viewAt(25, 10);
  const auto pose = tracker->track(face_->render(rig_, back));
  ASSERT_TRUE(pose.isTracked());
  EXPECT_LT(errorOf(*pose, back).at_point_mm, 0.3);
}

TEST_F(HeadTrackers, AFaceLostAtTheSideIsFoundAgainThere) {
  const auto tracker = head_tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  for (int i = 0; i <= 7; ++i)  // turns to 28 degrees
    ASSERT_TRUE(tracker->track(face_->render(rig_, turnedView(i, 4.0 * i))).isTracked()) << i;
  SyntheticView hidden = turnedView(8, 28);
  hidden.cover_mm = cv::Rect2d(-200, -200, 400, 400);
  EXPECT_FALSE(tracker->track(face_->render(rig_, hidden)).isTracked());
  SyntheticView back = turnedView(30, 26);  // later than a prediction is valid
  back.motion.pretranslate(Eigen::Vector3d(-25, 15, 20));
  int frames = 0;
  for (bool is_found = false; !is_found && frames < 6; ++frames) {
    back.seed = 100 + std::uint64_t(frames), back.time_s += 1.0 / 30;
    const auto pose = tracker->track(face_->render(rig_, back));
    is_found = pose.isTracked();
    if (is_found) {
      EXPECT_LT(errorOf(*pose, back).at_point_mm, 0.5);
    }
  }
  EXPECT_LT(frames, 6) << "0.2 s";
}

/// Large step, as between two axes of the paper's protractor or with few frames per second. The work of a
/// frame is limited, so the fit may be deferred to the next one.
TEST_F(HeadTrackers, AFaceThatLeapsIsFoundInTheSameFrameOrTheNext) {
  const auto tracker = head_tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  int frame = 0;
  for (const double yaw_deg : {0.0, 10.0, -14.0, 12.0, -12.0, 14.0}) {
    bool is_found = false;
    for (int i = 0; i < 2 && !is_found; ++i) {
      const SyntheticView view = turnedView(frame++, yaw_deg);
      const auto pose = tracker->track(face_->render(rig_, view));
      is_found = pose.isTracked();
      if (is_found) {
        EXPECT_LT(errorOf(*pose, view).at_point_mm, 0.5) << yaw_deg << " deg";
      }
    }
    EXPECT_TRUE(is_found) << yaw_deg << " deg";
  }
}

/// The coil has waited: the head gets only the first part of the frame's budget, but not in two frames
/// running.
TEST_F(HeadTrackers, ALostFaceLeavesRoomForTheCoilAndIsFoundAllTheSame) {
  const auto tracker = head_tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  constexpr int kWanted = 3000;
  int frame = 0;
  for (const double yaw_deg : {0.0, 12.0, -14.0, 10.0}) {
    bool is_found = false;
    for (int i = 0; i < 4 && !is_found; ++i) {
      const SyntheticView view = turnedView(frame, yaw_deg);
      const auto image = face_->render(rig_, view);
      const auto pose = tracker->track(image, {{kWanted}, false});
      const int most = FrameWork::most() - (frame++ % 2 == 0 ? kWanted : 0);
      EXPECT_LE(pose.work.comparisons, most) << frame;
      is_found = pose.isTracked();
      if (is_found) {
        EXPECT_LT(errorOf(*pose, view).at_point_mm, 0.5) << yaw_deg << " deg";
      }
    }
    EXPECT_TRUE(is_found) << yaw_deg << " deg";
  }
}

}  // namespace
}  // namespace facenav
