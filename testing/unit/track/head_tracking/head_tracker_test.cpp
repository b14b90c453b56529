// Both head trackers follow a synthetic face with known motion.

#include "head_scene.h"

namespace facenav {
namespace {

using namespace head_tracking::testing;
using testing::SyntheticFace;
using testing::SyntheticView;

TEST_F(HeadTrackers, Features7FollowsWithinTwoMillimetresAtTheCortex) {
  const auto tracker = peers::makeFeatureHeadTracker(detector());
  start(*tracker, false);
  const Errors errors = follow(*tracker, sweep(8, 6));
  EXPECT_EQ(errors.lost, 0);
  EXPECT_LT(errors.target_rms_mm, 2.0);
  EXPECT_LT(errors.rotation_rms_deg, 1.2);
  EXPECT_LT(errors.worst_mm, 3.0);
}

TEST_F(HeadTrackers, ModelFollowsWithinTwoTenthsOfAMillimetreAtTheCortex) {
  const auto tracker = head_tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  const Errors errors = follow(*tracker, sweep(15, 5));
  EXPECT_EQ(errors.lost, 0);
  EXPECT_LT(errors.target_rms_mm, 0.2);
  EXPECT_LT(errors.rotation_rms_deg, 0.1);
}

TEST_F(HeadTrackers, ModelReachesThirtyDegreesOfYaw) {
  const auto tracker = head_tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  const Errors errors = follow(*tracker, sweep(30, 2, 50));
  EXPECT_EQ(errors.lost, 0);
  EXPECT_LT(errors.target_rms_mm, 0.35);
}

TEST_F(HeadTrackers, ModelLearnsDepthFromThePlainPairWhereThereIsNoCloud) {
  const auto tracker = head_tracking::makeModelHeadTracker(detector());
  start(*tracker, false);
  const Errors errors = follow(*tracker, sweep(10, 5));
  EXPECT_EQ(errors.lost, 0);
  EXPECT_LT(errors.target_rms_mm, 0.4);
  EXPECT_LT(errors.rotation_rms_deg, 0.25);
}

TEST_F(HeadTrackers, ModelHoldsAStillHeadWithinAFewHundredthsOfAMillimetre) {
  const auto tracker = head_tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  std::vector<SyntheticView> views;
  for (int i = 0; i < 8; ++i) views.push_back(stillView(i));
  EXPECT_LT(follow(*tracker, views).target_rms_mm, 0.08);
}

TEST_F(HeadTrackers, ModelBearsOtherLightAMovingJawAndACoveredCheek) {
  const auto tracker = head_tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  std::vector<SyntheticView> views;
  for (int i = 0; i < 8; ++i) {
    SyntheticView view = viewAt(i, 10);
    view.gain = 1.0 + 0.4 * (i % 2 ? 1 : -1) * std::min(1.0, i / 4.0);
    view.lamp_x = -0.3 + 0.1 * i;
    view.jaw_drop_mm = 1.0 * (i % 4);
    if (i > 2) view.cover_mm = cv::Rect2d(15, -80, 60, 75);
    views.push_back(view);
  }
  const Errors errors = follow(*tracker, views);
  EXPECT_EQ(errors.lost, 0);
  EXPECT_LT(errors.worst_mm, 1.0);
}

TEST_F(HeadTrackers, FirstFrameMayBeFarFromTheReference) {
  const auto tracker = head_tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  SyntheticView view = viewAt(12, 12);
  view.motion.pretranslate(Eigen::Vector3d(-30, 25, 50));
  const auto pose = tracker->track(face_->render(rig_, view));
  ASSERT_TRUE(pose.isTracked());
  EXPECT_LT(errorOf(*pose, view).at_point_mm, 0.3);
}

TEST_F(HeadTrackers, AHeadThatStartsAtTheSideIsFoundThere) {
  const auto tracker = head_tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  for (const auto& [yaw_deg, nod_deg, lean_deg] :
       {std::array{30.0, 0.0, 10.0}, std::array{-30.0, 10.0, 0.0}, std::array{22.0, -15.0, -15.0}}) {
    int frame = 0;
    for (; frame < 6; ++frame) {  // 0.2 s at 30 fps
      SyntheticView view = turnedView(frame, yaw_deg);
      view.motion = view.motion * Eigen::Translation3d(0, 0, 640) *
                    Eigen::AngleAxisd(nod_deg * kRadPerDeg, Eigen::Vector3d::UnitX()) *
                    Eigen::AngleAxisd(lean_deg * kRadPerDeg, Eigen::Vector3d::UnitZ()) *
                    Eigen::Translation3d(0, 0, -640);
      const auto pose = tracker->track(face_->render(rig_, view), {{}, frame == 0});
      if (!pose) continue;
      EXPECT_LT(errorOf(*pose, view).at_point_mm, 1.5) << yaw_deg;
      break;
    }
    EXPECT_LT(frame, 6) << yaw_deg << ' ' << nod_deg << ' ' << lean_deg;
  }
}

TEST_F(HeadTrackers, TheSameFramesGiveTheSamePoses) {
  const auto frame = face_->render(rig_, viewAt(5, 10));
  Eigen::Matrix4d poses[2];
  for (auto& matrix : poses) {
    const auto tracker = head_tracking::makeModelHeadTracker(detector());
    start(*tracker, true);
    const auto pose = tracker->track(frame);
    ASSERT_TRUE(pose.isTracked());
    matrix = pose->camera_T_head.matrix();
  }
  EXPECT_EQ((poses[0] - poses[1]).cwiseAbs().maxCoeff(), 0.0);
}

TEST_F(HeadTrackers, RefuseToStartWithoutAFace) {
  head_tracking::HeadReference nothing;
  nothing.frame.left = cv::Mat(480, 640, CV_8U, cv::Scalar(90));
  nothing.frame.right = nothing.frame.left.clone();
  EXPECT_THROW(head_tracking::makeModelHeadTracker(detector())->start(rig_, nothing), Error);
  EXPECT_THROW(peers::makeFeatureHeadTracker(detector())->start(rig_, nothing), Error);
}

}  // namespace
}  // namespace facenav
