#include <gtest/gtest.h>

#include "made_targets.h"
#include "support/matchers.h"

#include "facenav/geometry/rotation.h"

namespace facenav::guidance {
namespace {
using namespace guidance::testing;
using facenav::testing::EigenNear;

// Compares with a published navigator export with 3 decimals; `point` is the target itself.
TEST(Evaluate, GivesThePublishedRecordingsValues) {
  Target target;
  target.mri_T_target =
      poseFrom<frames::Target>({-37.524, -11.972, 57.554}, {-.493, -.172, .853}, {.467, .774, .427});
  target.cortex_point = Point<Mri>(-37.524, -11.972, 57.554);
  const auto coil = poseFrom<Coil>({-39.498, -12.015, 62.760}, {-.547, -.115, .829}, {.430, .812, .395});
  const GuidanceValues values = evaluate(target, coil);
  EXPECT_NEAR(values.distance_mm, 5.568, 0.001);
  EXPECT_NEAR(values.beam_miss_mm, 1.348, 0.005);
  EXPECT_NEAR(values.tilt_rad * kDegPerRad, 4.702,
              0.06);  // 5e-4 on a unit vector's components is 0.05 degrees
  EXPECT_NEAR(std::abs(values.twist_rad) * kDegPerRad, 3.474, 0.06);
  EXPECT_NEAR(std::hypot(values.lateral_mm, values.depth_mm), values.distance_mm, 1e-9);
}

TEST(Evaluate, IsZeroOnTarget) {
  const Target target = vertexTarget();
  const GuidanceValues values = evaluate(target, coilAt(target, {0, 0, 0}));
  EXPECT_NEAR(values.distance_mm + values.lateral_mm + values.tilt_rad + values.beam_miss_mm, 0, 1e-12);
  EXPECT_NEAR(values.twist_rad, 0, 1e-12);
}

TEST(Evaluate, SplitsDistanceIntoLateralAndSignedDepth) {
  const Target target = vertexTarget();
  const GuidanceValues off = evaluate(target, coilAt(target, {3, 4, -12}));
  EXPECT_NEAR(off.distance_mm, 13, 1e-9);
  EXPECT_NEAR(off.lateral_mm, 5, 1e-9);
  EXPECT_NEAR(off.depth_mm, -12, 1e-9);  // above the scalp
  EXPECT_NEAR(off.beam_miss_mm, 5, 1e-9);
  EXPECT_THAT(off.lateral_in_coil_mm, EigenNear(Eigen::Vector2d(-3, -4), 1e-9));
  EXPECT_GT(evaluate(target, coilAt(target, {0, 0, 2})).depth_mm, 0);  // too deep
}

TEST(Evaluate, BeamMissSeesTiltThatTheContactPointHides) {
  const Target target = vertexTarget();  // cortex point 20 mm along the target's z
  const GuidanceValues values =
      evaluate(target, coilAt(target, {0, 0, 0}, about(Eigen::Vector3d::UnitX(), 10)));
  EXPECT_NEAR(values.distance_mm, 0, 1e-12);
  EXPECT_NEAR(values.beam_miss_mm, 20 * std::sin(rad(10)), 1e-9);
}

TEST(Evaluate, TiltAndTwistAreThoseOfSwingAfterTwist) {
  const Target target = vertexTarget();
  const Eigen::Vector3d across = Eigen::Vector3d(1, 2, 0).normalized();
  for (const double twist_deg : {-170.0, -35.0, 0.0, 8.0, 120.0})
    for (const double tilt_deg : {0.0, 5.0, 40.0, 100.0}) {
      const GuidanceValues values = evaluate(
          target,
          coilAt(target, {0, 0, 0}, about(across, tilt_deg) * about(Eigen::Vector3d::UnitZ(), twist_deg)));
      EXPECT_NEAR(values.tilt_rad, rad(tilt_deg), 1e-9);
      EXPECT_NEAR(values.twist_rad, rad(twist_deg), 1e-9);
    }
}

TEST(Evaluate, TiltInCoilIsTheRotationThatAlignsTheAxes) {
  const Target target = vertexTarget();
  const auto coil = coilAt(target, {5, 1, 2}, about(Eigen::Vector3d(3, -1, 0.5).normalized(), 25));
  const Eigen::Vector2d tilt_rad = evaluate(target, coil).tilt_in_coil_rad;
  const Eigen::AngleAxisd correction(tilt_rad.norm(),
                                     Eigen::Vector3d(tilt_rad.x(), tilt_rad.y(), 0).normalized());
  const Eigen::Vector3d z = coil.rotation() * correction.toRotationMatrix().col(2);
  EXPECT_THAT(z, EigenNear(target.mri_T_target.rotation().col(2), 1e-9));
}

TEST(Evaluate, DoesNotDependOnWhereTheCameraStands) {
  const Target target = vertexTarget();
  const auto mri_T_coil = coilAt(target, {3, 4, -5}, about(Eigen::Vector3d(1, 1, 1).normalized(), 20));
  const RigidTransform<Camera, Mri> camera_T_mri(Eigen::Quaterniond(0.3, -0.5, 0.4, 0.7), {120, -40, 650});
  const auto state = evaluate(target, Tracked<RigidTransform<Camera, Mri>>(camera_T_mri, 1.0),
                              Tracked<RigidTransform<Camera, Coil>>(camera_T_mri * mri_T_coil, 1.0), {}, 0.4);
  ASSERT_TRUE(state.values);
  EXPECT_EQ(state.state, State::adjust);
  EXPECT_DOUBLE_EQ(state.predicted_error_mm, 0.4);
  EXPECT_NEAR(state.values->distance_mm, evaluate(target, mri_T_coil).distance_mm, 1e-9);
  EXPECT_NEAR(state.values->twist_rad, evaluate(target, mri_T_coil).twist_rad, 1e-9);
}

TEST(Evaluate, ShowsNoValuesWhenHeadOrCoilIsLost) {
  const Target target = vertexTarget();
  const Tracked<RigidTransform<Camera, Mri>> head({}, 1.0), no_head(Lost{LostReason::no_face});
  const Tracked<RigidTransform<Camera, Coil>> coil({}, 1.0), no_coil(Lost{LostReason::no_marker});
  for (const GuidanceState& state :
       {evaluate(target, no_head, coil, {}, 0), evaluate(target, head, no_coil, {}, 0),
        evaluate(target, no_head, no_coil, {}, 0)}) {
    EXPECT_EQ(state.state, State::lost);
    EXPECT_FALSE(state.values);
    EXPECT_EQ(state.action, Action::none);
    EXPECT_EQ(state.instruction.rfind("lost", 0), 0u);
  }
  EXPECT_EQ(evaluate(target, no_head, no_coil, {}, 0).reason, LostReason::no_face);
  EXPECT_EQ(evaluate(target, head, no_coil, {}, 0).reason, LostReason::no_marker);
}

}  // namespace
}  // namespace facenav::guidance
