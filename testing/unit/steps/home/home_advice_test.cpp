#include "facenav/home/home_advice.h"

#include <gmock/gmock.h>

#include "facenav/geometry/rotation.h"
#include "unit/treat/session/session_fakes.h"

namespace facenav::steps {
namespace {

namespace fakes = session::fakes;
using head_tracking::LossDetail;
using ::testing::HasSubstr;

const RigidTransform<Camera, Coil> kCoil(Eigen::Quaterniond::Identity(), {20, -60, 550});

/// State with the coil `off` the target and everything tracked.
session::NavigationState seen(const RigidTransform<Coil, Coil>& off = {}) {
  session::NavigationState state;
  state.frame = 1;
  state.camera_T_mri = {fakes::cameraAtReference(), 0.9};
  state.camera_T_coil = {kCoil * off, 0.9};
  const auto chosen = fakes::targetAt(kCoil);
  state.guidance = guidance::evaluate(chosen.target, state.camera_T_mri, state.camera_T_coil, {}, 0.5);
  return state;
}
RigidTransform<Coil, Coil> shifted(double x, double y, double z) {
  return {Eigen::Quaterniond::Identity(), {x, y, z}};
}
RigidTransform<Coil, Coil> turnedBy(const Eigen::Vector3d& deg) {
  return {Eigen::Quaterniond(expRotation(kRadPerDeg * deg)), Eigen::Vector3d::Zero()};
}

TEST(HomeAdvice, OnTargetSaysHold) {
  const auto advice = homeAdvice(seen(), false);
  EXPECT_EQ(advice.step, HomeStep::follow);
  EXPECT_EQ(advice.sign, HomeSign::hold);
  EXPECT_FALSE(advice.is_refused);
}

TEST(HomeAdvice, TheArrowPointsWhereTheCoilMustGoSeenFromBehindTheHandle) {
  // The coil's +x is on the left of a person behind the handle; a coil that is too far left must go right.
  const auto right = homeAdvice(seen(shifted(8, 0, 0)), false);
  EXPECT_EQ(right.sign, HomeSign::arrow);
  EXPECT_NEAR(right.arrow_rad, M_PI / 2, 1e-6);
  EXPECT_THAT(right.words, HasSubstr("8\u00a0mm"));
  EXPECT_NEAR(homeAdvice(seen(shifted(-8, 0, 0)), false).arrow_rad, -M_PI / 2, 1e-6);
  EXPECT_NEAR(homeAdvice(seen(shifted(0, -8, 0)), false).arrow_rad, 0, 1e-6) << "too far back: ahead";
  EXPECT_NEAR(std::abs(homeAdvice(seen(shifted(0, 8, 0)), false).arrow_rad), M_PI, 1e-6);
}

TEST(HomeAdvice, DepthTiltAndTurnHaveTheirOwnSigns) {
  EXPECT_EQ(homeAdvice(seen(shifted(0, 0, 9)), false).sign, HomeSign::lift) << "+z is into the head";
  EXPECT_EQ(homeAdvice(seen(shifted(0, 0, -9)), false).sign, HomeSign::press);
  const auto turn = homeAdvice(seen(turnedBy({0, 0, 20})), false),
             back = homeAdvice(seen(turnedBy({0, 0, -20})), false);
  // Seen along +z, into the head, a positive rotation is clockwise; the correction is anticlockwise.
  EXPECT_EQ(turn.sign, HomeSign::turn_counterclockwise);
  EXPECT_EQ(back.sign, HomeSign::turn_clockwise);
  for (const Eigen::Vector3d& tilt : {Eigen::Vector3d(12, 0, 0), {-12, 0, 0}, {0, 12, 0}, {0, -12, 0}}) {
    const auto advice = homeAdvice(seen(turnedBy(tilt)), false);
    // A rotation about +x raises the side of -y, the handle's (out of the head, -z); it must go back.
    const HomeSign expected = tilt.x() > 0   ? HomeSign::raise_front
                              : tilt.x() < 0 ? HomeSign::raise_handle
                              : tilt.y() > 0 ? HomeSign::raise_right
                                             : HomeSign::raise_left;
    EXPECT_EQ(advice.sign, expected) << tilt.transpose();
  }
}

TEST(HomeAdvice, WhatIsNotKnownShowsNoArrow) {
  auto state = seen(shifted(8, 0, 0));
  state.camera_T_coil = Lost{LostReason::no_marker};
  auto advice = homeAdvice(state, false);
  EXPECT_EQ(advice.step, HomeStep::hold);
  EXPECT_EQ(advice.sign, HomeSign::none);
  EXPECT_FALSE(advice.is_refused);
  advice = homeAdvice(state, true);
  EXPECT_TRUE(advice.is_refused);
  EXPECT_THAT(advice.words, HasSubstr("not the coil"));
  state.camera_T_mri = Lost{LostReason::no_face};
  for (const auto& [detail, words, is_refused] : {std::tuple(LossDetail::other_face, "not the person", true),
                                                  {LossDetail::covered, "hidden", false},
                                                  {LossDetail::too_far, "nearer", false},
                                                  {LossDetail::not_found, "not seen", false}}) {
    state.head_detail = detail;
    advice = homeAdvice(state, false);
    EXPECT_EQ(advice.sign, HomeSign::none);
    EXPECT_EQ(advice.step, HomeStep::sit);
    EXPECT_EQ(advice.is_refused, is_refused);
    EXPECT_THAT(advice.words, HasSubstr(words));
  }
}

TEST(HomeAdvice, AFaultOfTheCamerasComesFirst) {
  auto state = seen();
  using monitoring::Withheld;
  state.withheld = Withheld{
      Withheld::Reason::camera_fault, Withheld::Source::cameras, {health::RigState::moved, "moved", ""}};
  auto advice = homeAdvice(state, false);
  EXPECT_TRUE(advice.is_refused);
  EXPECT_THAT(advice.words, HasSubstr("moved"));
  state.withheld = Withheld{Withheld::Reason::registration_failed, Withheld::Source::registration_check};
  state.camera_T_mri = Lost{LostReason::high_residual};
  EXPECT_THAT(homeAdvice(state, false).words, HasSubstr("no longer fits"));
  state.failure = "a camera vanished";
  EXPECT_TRUE(homeAdvice(state, false).is_refused);
}

TEST(HomeRefusal, IsOneSentenceForEachCause) {
  EXPECT_THAT(homeRefusal(Error("not aligned: the face does not fit this MRI (40 % of it lies on the skin)")),
              HasSubstr("not the stored one"));
  EXPECT_THAT(homeRefusal(Error("not aligned: too little of the face was measured")),
              HasSubstr("Too little"));
  EXPECT_THAT(homeRefusal(Error("not aligned: the cameras moved against each other")),
              HasSubstr("cameras were moved"));
  EXPECT_THAT(homeRefusal(Error("not aligned: the capture's picture for the dots shows none, or too few "
                                "(switch the projector on)")),
              HasSubstr("projector"));
  EXPECT_THAT(homeRefusal(Error("no picture was taken: hold the coil still")),
              HasSubstr("still beside the face"));
  EXPECT_THAT(
      homeRefusal(Error("no picture was taken: the coil's marker does not fit the cameras' calibration")),
      HasSubstr("cameras were moved"));
  EXPECT_THAT(homeRefusal(Error("not aligned: without dots the face alone does not show whether a camera")),
              HasSubstr("still beside the face"));
  EXPECT_THAT(
      homeRefusal(Error("not aligned: without dots the face alone does not show whether a camera has "
                        "turned; the stored face was measured without the coil's marker in the picture")),
      HasSubstr("ask the clinic"));
  EXPECT_EQ(homeRefusal(Error("disk full")), "disk full");
}

}  // namespace
}  // namespace facenav::steps
