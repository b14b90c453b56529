#include "head/head_motion.h"

#include <gtest/gtest.h>

#include "head/late_camera.h"
#include "support/stereo_rigs.h"

namespace facenav::head_tracking {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;

const Eigen::Vector3d kCentre(10, -20, 600);

Vector6d velocity() {
  Vector6d v;
  v << 0.3, -0.5, 0.2, 40, -60, 25;
  return v;
}

/// Pose of a head that moves steadily, in its own axes, about its centre.
Isometry3d poseAt(double time_s, const Vector6d& v = velocity()) {
  return Isometry3d(Translation3d(5, 6, 7)) * Translation3d(kCentre) * expRigid(v * time_s) *
         Translation3d(-kCentre);
}

double apart_mm(const Isometry3d& a, const Isometry3d& b) {
  double most = 0;
  for (const auto& p : {kCentre, Eigen::Vector3d(kCentre + Eigen::Vector3d(60, 70, 90))})
    most = std::max(most, (a * p - b * p).norm());
  return most;
}

HeadMotion after(double seconds, double frame_s = 1.0 / 60) {
  HeadMotion motion(kCentre);
  for (int i = 0; i * frame_s <= seconds; ++i) motion.add(poseAt(i * frame_s), {i * frame_s});
  return motion;
}

TEST(HeadMotion, PredictsTurnAndShiftAboutTheCentre) {
  Vector6d turn = Vector6d::Zero(), shift = Vector6d::Zero();
  turn[1] = 0.8;
  shift[3] = 120;
  for (const Vector6d& v : {turn, shift}) {
    HeadMotion motion(kCentre);
    motion.add(poseAt(0, v), {0});
    motion.add(poseAt(1.0 / 60, v), {1.0 / 60});
    EXPECT_LT((motion.velocity() - v).norm(), 1e-6);
    EXPECT_LT(apart_mm(motion.predicted({3.0 / 60}), poseAt(3.0 / 60, v)), 1e-6);
  }
}

TEST(HeadMotion, AScrewMotionIsPredictedToHundredthsOfAMillimetre) {
  const HeadMotion motion = after(0.5);
  const double last_s = motion.captured().s;
  EXPECT_LT(apart_mm(motion.predicted({last_s + 1.0 / 60}), poseAt(last_s + 1.0 / 60)), 0.05);
  EXPECT_LT(apart_mm(motion.predicted({last_s}), motion.pose()), 1e-9);
}

TEST(HeadMotion, TheFirstPoseHasNoVelocity) {
  HeadMotion motion(kCentre);
  EXPECT_FALSE(motion.isKnown());
  EXPECT_FALSE(motion.isRecent({0}));
  motion.add(poseAt(0), {10});
  EXPECT_TRUE(motion.isKnown());
  EXPECT_TRUE(motion.velocity().isZero(0));
  EXPECT_LT(apart_mm(motion.predicted({10.1}), poseAt(0)), 1e-9);
}

TEST(HeadMotion, NothingIsPredictedAcrossALongGap) {
  HeadMotion motion = after(0.2);
  const double last_s = motion.captured().s;
  EXPECT_TRUE(motion.isRecent({last_s + 0.29}));
  EXPECT_FALSE(motion.isRecent({last_s + 0.31}));
  EXPECT_FALSE(motion.isRecent({last_s - 0.01})) << "no frame from the past";
  motion.add(poseAt(last_s + 0.5), {last_s + 0.5});
  EXPECT_TRUE(motion.velocity().isZero(0));
}

TEST(HeadMotion, TwoPosesOfOneMomentGiveNoSpeed) {
  HeadMotion motion(kCentre);
  motion.add(poseAt(0), {1.0});
  motion.add(poseAt(0.1), {1.0 + 1e-6});
  EXPECT_TRUE(motion.velocity().isZero(0));
  EXPECT_TRUE(motion.steadyWith(poseAt(0.2), {1.0 + 2e-6}).isApprox(motion.steady()));
}

TEST(HeadMotion, TheSteadyVelocityFollowsWithinThirtyMilliseconds) {
  // The head rests, then moves at full speed: the estimate reaches 1 - 1/e of it after the time constant, at
  // any frame rate.
  for (const double frame_s : {0.001, 0.003}) {
    Vector6d v = Vector6d::Zero();
    v[3] = 100;
    HeadMotion motion(kCentre);
    motion.add(poseAt(0, v), {0});
    motion.add(poseAt(0, v), {frame_s});
    const int frames = int(std::lround(0.03 / frame_s));
    for (int i = 1; i <= frames; ++i) motion.add(poseAt(i * frame_s, v), {(i + 1) * frame_s});
    EXPECT_NEAR(motion.steady()[3], 100 * (1 - std::exp(-1.0)), 0.5) << frame_s;
    EXPECT_NEAR(motion.velocity()[3], 100, 1e-6);
  }
}

TEST(HeadMotion, SpeedBehindTheFaceAddsTheTurnsLever) {
  const HeadMotion motion = after(1.0);
  const Vector6d v = motion.steady();
  EXPECT_NEAR(motion.speedBehind_mm_s(0), v.tail<3>().norm(), 1e-9);
  EXPECT_NEAR(motion.speedBehind_mm_s(90) - motion.speedBehind_mm_s(0), 90 * v.head<3>().norm(), 1e-9);
}

TEST(HeadMotion, StopsAndForgets) {
  HeadMotion motion = after(0.3);
  motion.stop();
  EXPECT_TRUE(motion.velocity().isZero(0));
  EXPECT_TRUE(motion.steady().isZero(0));
  EXPECT_TRUE(motion.isKnown());
  motion.forget();
  EXPECT_FALSE(motion.isKnown());
  motion.add(poseAt(0), {1}), motion.add(poseAt(1.0 / 60), {1 + 1.0 / 60});
  EXPECT_LT((motion.velocity() - velocity()).tail<3>().norm(), 0.5) << "the centre is kept";
}

TEST(LateCamera, ASynchronousRigStaysTheRig) {
  const cameras::StereoRig rig = facenav::testing::convergingRig();
  LateCamera late(rig, kCentre);
  EXPECT_EQ(late.late_s(), 0.0);
  EXPECT_GT(late.mostLate_s(), 0.0) << "what is not known is said";
  late.allowFor(KeyFrame(), poseAt(0.1), velocity());
  EXPECT_TRUE(late.now().right_T_left.isometry().isApprox(rig.right_T_left.isometry(), 1e-9));
  EXPECT_TRUE(late.motionOf(velocity()).allowed.isZero(0));
  EXPECT_TRUE(late.motionOf(velocity()).velocity == velocity());
}

TEST(LateCamera, TheRightCameraSeesTheHeadWhereItIsLater) {
  const cameras::StereoRig rig = facenav::testing::convergingRig();
  const LateCamera late(rig, kCentre);
  const Isometry3d pose = poseAt(0.3);
  const KeyMotion moving{velocity(), 0.012 * velocity()};  // 12 ms later
  const Isometry3d right = late.rigFor(pose, moving).right_T_left.isometry();
  const Isometry3d later =
      pose * Translation3d(kCentre) * expRigid(0.012 * velocity()) * Translation3d(-kCentre);
  for (const Eigen::Vector3d& p_head :
       {kCentre, Eigen::Vector3d(60, 40, 580), Eigen::Vector3d(-50, -70, 640)})
    EXPECT_LT((right * pose * p_head - rig.right_T_left.isometry() * later * p_head).norm(), 1e-6);
}

TEST(LateCamera, AllowsForWhatTheKeyFramesImagesAlreadyShow) {
  LateCamera late(facenav::testing::convergingRig(), kCentre);
  KeyFrame key;
  key.moving = {velocity(), 0.01 * velocity()};
  const Isometry3d pose = poseAt(0.2);
  late.allowFor(key, pose, velocity());
  const auto expected = late.rigFor(pose, key.moving).right_T_left;
  EXPECT_TRUE(late.now().right_T_left.isometry().isApprox(expected.isometry(), 1e-9));
}

TEST(LateCamera, LearnsNothingFromTheSameMoment) {
  LateCamera late(facenav::testing::convergingRig(), kCentre);
  HeadMotion before = after(0.1);
  Verdict verdict;
  verdict.covariance.setIdentity();
  const double sigma_s = late.sigma_s();
  const Verdict same = late.learn(KeyFrame(), PoseFit(), before, before.captured(), verdict);
  EXPECT_TRUE(same.covariance == verdict.covariance);
  EXPECT_EQ(late.sigma_s(), sigma_s);
}

}  // namespace
}  // namespace facenav::head_tracking
