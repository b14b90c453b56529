#include "facenav/session/pulse_pose.h"

#include <gmock/gmock.h>

#include "session_fakes.h"
#include "support/ball_mesh.h"
#include "support/matchers.h"

namespace facenav::session {
namespace {

using casefile::PulseStatus;
using facenav::testing::PoseNear;
using ::testing::HasSubstr;

const RigidTransform<Camera, facenav::Coil> kCoil(Eigen::Quaterniond::Identity(), {20, -60, 550});

/// Frame taken at `taken_s` of the steady clock, 1000 s ahead of the source's; the coil is `off_mm` along its
/// x.
PosedFrame frameAt(std::int64_t number, double taken_s, double off_mm = 0.0) {
  PosedFrame frame;
  frame.frame = number;
  frame.captured = {taken_s - 1000.0};
  frame.taken = {taken_s};
  frame.camera_T_mri = fakes::cameraAtReference();
  frame.camera_T_coil =
      kCoil * RigidTransform<facenav::Coil, facenav::Coil>(Eigen::Quaterniond::Identity(), {off_mm, 0, 0});
  ChosenTarget chosen = fakes::targetAt(kCoil);
  chosen.predicted_error_mm = 0.7;
  chosen.target.note = "private";
  frame.chosen = std::make_shared<const ChosenTarget>(chosen);
  return frame;
}

PulseTrigger triggerAt(double at_s) {
  PulseTrigger trigger;
  trigger.at = {at_s};
  return trigger;
}

TEST(PulsePose, HeadAndCoilAreInterpolatedToThePulsesOwnTime) {
  PosedFrame before = frameAt(7, 2000.00, 0.4), after = frameAt(8, 2000.04, 1.2);
  const RigidTransform<Camera, Camera> moved(
      Eigen::Quaterniond(Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitY())), {0, 0, 0});
  after.camera_T_mri = moved * *before.camera_T_mri;
  after.camera_T_coil = moved * *after.camera_T_coil;
  const auto pulse = pulseBetween(triggerAt(2000.01), before, after);
  EXPECT_NEAR(*pulse.t_s, 1000.01, 1e-9);
  EXPECT_NEAR(pulse.steady_s, 2000.01, 1e-9);
  EXPECT_NEAR(pulse.fraction, 0.25, 1e-9);
  EXPECT_EQ(*pulse.frames, (std::array<std::int64_t, 2>{7, 8}));
  const RigidTransform<Camera, Camera> quarter(
      Eigen::Quaterniond(Eigen::AngleAxisd(0.005, Eigen::Vector3d::UnitY())), {0, 0, 0});
  // A chord instead of the arc: a radius of 600 mm over 0.02 rad is 0.03 mm high, 0.0225 mm at a quarter.
  EXPECT_THAT(*pulse.camera_T_mri, PoseNear(quarter * fakes::cameraAtReference(), 1e-6, 0.03));
  EXPECT_EQ(pulse.status, PulseStatus::on_target);
  EXPECT_EQ(pulse.reason, "");
  EXPECT_NEAR(pulse.offset->distance_mm, 0.6, 0.01) << "a quarter of the way from 0.4 to 1.2 mm";
  EXPECT_EQ(pulse.target->name, "spot");
  EXPECT_EQ(pulse.target->note, "") << "notes may name people";
  EXPECT_DOUBLE_EQ(*pulse.predicted_error_mm, 0.7);
}

TEST(PulsePose, OutsideTheToleranceSaysWhatWasOff) {
  const auto pulse = pulseBetween(triggerAt(2000.02), frameAt(1, 2000.0, 3.4), frameAt(2, 2000.04, 3.4));
  EXPECT_EQ(pulse.status, PulseStatus::outside);
  EXPECT_EQ(pulse.reason, "3.4 mm beside the target (2.0 allowed)");
  EXPECT_NEAR(pulse.offset->lateral_mm, 3.4, 1e-9);
}

TEST(PulsePose, InAPauseThePoseIsKeptAndNothingIsOnTarget) {
  PulseTrigger trigger = triggerAt(2000.02);
  trigger.is_in_pause = true;
  const auto pulse = pulseBetween(trigger, frameAt(1, 2000.0), frameAt(2, 2000.04));
  EXPECT_EQ(pulse.status, PulseStatus::outside);
  EXPECT_EQ(pulse.reason, "given in a pause");
  EXPECT_TRUE(pulse.mri_T_coil());
  const auto off = pulseBetween(trigger, frameAt(1, 2000.0, 3.4), frameAt(2, 2000.04, 3.4));
  EXPECT_EQ(off.reason, "given in a pause; 3.4 mm beside the target (2.0 allowed)");
}

TEST(PulsePose, LostOnOneSideOnlyIsLostAndSaysWhy) {
  for (const bool is_before : {true, false}) {
    PosedFrame before = frameAt(1, 2000.0), after = frameAt(2, 2000.04);
    PosedFrame& lost = is_before ? before : after;
    lost.camera_T_mri.reset();
    lost.loss = "face covered";
    const auto pulse = pulseBetween(triggerAt(2000.01), before, after);
    EXPECT_EQ(pulse.status, PulseStatus::lost);
    EXPECT_EQ(pulse.reason, "face covered");
    EXPECT_FALSE(pulse.mri_T_coil());
    EXPECT_TRUE(pulse.camera_T_coil) << "the coil was seen";
    EXPECT_FALSE(pulse.offset);
    EXPECT_NEAR(*pulse.t_s, 1000.01, 1e-9);
  }
}

TEST(PulsePose, WithoutAFrameOnEitherSideOrInTimeThePoseIsLost) {
  const auto early = pulseBetween(triggerAt(1999.9), std::nullopt, frameAt(1, 2000.0));
  EXPECT_EQ(early.status, PulseStatus::lost);
  EXPECT_EQ(early.reason, "no picture before the pulse");
  EXPECT_NEAR(*early.t_s, 999.9, 1e-9);
  const auto late = pulseBetween(triggerAt(2000.1), frameAt(1, 2000.0), std::nullopt);
  EXPECT_EQ(late.status, PulseStatus::lost);
  EXPECT_THAT(late.reason, HasSubstr("after the pulse"));
  EXPECT_NEAR(*late.t_s, 1000.1, 1e-9);
  const auto sparse = pulseBetween(triggerAt(2000.1), frameAt(1, 2000.0), frameAt(2, 2000.3));
  EXPECT_EQ(sparse.status, PulseStatus::lost);
  EXPECT_EQ(sparse.reason, "no picture for 0.30 s");
  EXPECT_FALSE(pulseBetween(triggerAt(5.0), std::nullopt, std::nullopt).t_s);
}

TEST(PulsePose, WithoutATargetThePoseIsKeptAndTheStatusSaysSo) {
  PosedFrame before = frameAt(1, 2000.0), after = frameAt(2, 2000.04);
  before.chosen = after.chosen = nullptr;
  const auto pulse = pulseBetween(triggerAt(2000.01), before, after);
  EXPECT_EQ(pulse.status, PulseStatus::outside);
  EXPECT_EQ(pulse.reason, "no target was chosen");
  EXPECT_TRUE(pulse.mri_T_coil());
  EXPECT_FALSE(pulse.offset);
}

TEST(PulsePose, TheTargetIsThatOfTheFrameBefore) {
  const PosedFrame before = frameAt(1, 2000.0);
  PosedFrame after = frameAt(2, 2000.04);
  ChosenTarget other = *after.chosen;
  other.target.name = "other";
  after.chosen = std::make_shared<const ChosenTarget>(other);
  EXPECT_EQ(pulseBetween(triggerAt(2000.01), before, after).target->name, "spot");
}

TEST(PulsePose, AFramesLossIsNamedAsTheWindowNamesIt) {
  NavigationState state;
  state.is_aligned = true;
  state.head = Lost{LostReason::few_features};
  state.head_detail = head_tracking::LossDetail::covered;
  EXPECT_EQ(posedFrame(state).loss, "face covered or turned away");
}

registration::SkinModel ballSkin(double radius_mm, const Eigen::Vector3d& centre_mm) {
  registration::SkinModel skin;
  const auto mesh = facenav::testing::ballMesh(radius_mm, 60, 80);
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i) {
    skin.points.points_mm.push_back(mesh.vertices_mm[i] + centre_mm);
    skin.points.normals.push_back(mesh.normals[i]);
  }
  skin.triangles = mesh.triangles;
  return skin;
}

TEST(PulsePose, TheGapIsMeasuredToTheSkinAndTooLargeAGapIsOutside) {
  const PosedFrame frame = frameAt(1, 100.0), later = frameAt(2, 100.02);
  // A ball whose skin lies a known distance before the contact face, along the coil's z.
  const auto mri_T_coil = frame.camera_T_mri->inverse() * *frame.camera_T_coil;
  const Eigen::Vector3d z = mri_T_coil.rotation().col(2);
  for (const double gap_mm : {1.0, 2.5, 6.0}) {
    const registration::ScalpField scalp(ballSkin(90.0, mri_T_coil.translation_mm() + (90.0 + gap_mm) * z));
    const auto pulse = pulseBetween(triggerAt(100.01), frame, later, &scalp);
    ASSERT_TRUE(pulse.gap_mm);
    EXPECT_NEAR(*pulse.gap_mm, gap_mm, 0.3);
    EXPECT_EQ(pulse.status, gap_mm < 5 ? PulseStatus::on_target : PulseStatus::outside);
    if (gap_mm > 5) {
      EXPECT_THAT(pulse.reason, HasSubstr("gap of"));
    }
  }
  EXPECT_FALSE(pulseBetween(triggerAt(100.01), frame, later).gap_mm) << "no skin is known";
}

TEST(PulsePose, OverAHollowTheGapOfThePlannedCoilIsAllowed) {
  PosedFrame frame = frameAt(1, 100.0);
  const PosedFrame later = frameAt(2, 100.02);
  const auto mri_T_coil = frame.camera_T_mri->inverse() * *frame.camera_T_coil;
  ChosenTarget lifted = *frame.chosen;
  lifted.target.lift_mm = 5.0;  // the plate's rim touches, its centre is over the hollow
  lifted.target.scalp_point = mri_T_coil * Point<facenav::Coil>(0, 0, 5.0);
  frame.chosen = std::make_shared<const ChosenTarget>(lifted);
  const Eigen::Vector3d z = mri_T_coil.rotation().col(2);
  const auto pulseAt = [&](double gap_mm) {
    const registration::ScalpField scalp(ballSkin(90.0, mri_T_coil.translation_mm() + (90.0 + gap_mm) * z));
    return pulseBetween(triggerAt(100.01), frame, later, &scalp);
  };
  const auto held = pulseAt(5.0), high = pulseAt(9.0);
  EXPECT_EQ(held.status, PulseStatus::on_target) << held.reason;
  EXPECT_NEAR(held.gap_mm.value(), 5.0, 0.3);
  EXPECT_EQ(high.status, PulseStatus::outside);
  EXPECT_THAT(high.reason, HasSubstr("(5.0 planned, 3.0 more allowed)"));
}

TEST(PulsePose, WhereTheAlignmentIsTooUncertainNoPulseIsOnTarget) {
  PosedFrame frame = frameAt(1, 100.0);
  ChosenTarget uncertain = *frame.chosen;
  uncertain.error_bound_mm = 5.1;
  frame.chosen = std::make_shared<const ChosenTarget>(uncertain);
  const auto pulse = pulseBetween(triggerAt(100.01), frame, frameAt(2, 100.02));
  EXPECT_EQ(pulse.status, PulseStatus::outside);
  EXPECT_THAT(pulse.reason, HasSubstr("alignment too uncertain (95 % within 5.1 mm, 5.0 allowed)"));
}

}  // namespace
}  // namespace facenav::session
