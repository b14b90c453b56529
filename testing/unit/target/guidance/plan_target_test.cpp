#include <gtest/gtest.h>

#include "facenav/core/error.h"
#include "made_targets.h"
#include "support/matchers.h"

namespace facenav::guidance {
namespace {
using namespace guidance::testing;
using facenav::testing::EigenNear;

/// Centre of a head of 90 mm radius; the world origin lies elsewhere, as in a real scan.
const Eigen::Vector3d kCentre_mm(12, -30, 25);

surface::ScalpSurface roundHead() {
  surface::ScalpSurface scalp;
  scalp.mesh = sphere(kCentre_mm, 90);
  return scalp;
}

Point<Mri> under(const Eigen::Vector3d& direction, double depth_mm = 20) {
  return Point<Mri>(kCentre_mm + (90 - depth_mm) * direction.normalized());
}

TEST(PlanTarget, IsTangentOverTheCortexPoint) {
  const Eigen::Vector3d out = Eigen::Vector3d(-1, 0.2, 1).normalized();
  const Target target = planTarget("M1", roundHead(), under(out), rad(45), 4.0);
  EXPECT_THAT(target.scalp_point.mm, EigenNear(kCentre_mm + 90 * out, 0.3));
  EXPECT_THAT(target.mri_T_target.rotation().col(2), EigenNear(-out, 0.01));
  EXPECT_THAT(target.mri_T_target.translation_mm(), EigenNear(kCentre_mm + 94 * out, 0.3));
  EXPECT_NEAR(target.mri_T_target.rotation().determinant(), 1, 1e-12);
  const auto on_target = target.mri_T_target.reframe<Mri, Coil>();  // the wanted pose itself
  EXPECT_NEAR(evaluate(target, on_target).beam_miss_mm, 0, 1e-9);
  EXPECT_NEAR(evaluate(target, on_target).distance_mm, 0, 1e-9);
}

TEST(PlanTarget, HandleLeavesPosteriorLateralOnBothSides) {
  for (const double side : {-1.0, 1.0}) {
    const Target target = planTarget("M1", roundHead(), under({side, 0, 1}), rad(45));
    const Eigen::Vector3d handle = -target.mri_T_target.rotation().col(1);
    EXPECT_LT(handle.y(), -0.6) << "backward";
    EXPECT_GT(side * handle.x(), 0.4) << "away from the midline";
    EXPECT_NEAR(handle.y(), -std::cos(rad(45)), 0.02);
  }
}

TEST(PlanTarget, ZeroAngleHasTheHandleStraightBack) {
  const Target target = planTarget("M1", roundHead(), under({-0.3, 0, 1}), 0.0);
  EXPECT_THAT(target.mri_T_target.rotation().col(1), EigenNear(Eigen::Vector3d(0, 1, 0), 0.02));
}

TEST(PlanTarget, ForeheadTakesSuperiorForAnterior) {
  const Target target = planTarget("front", roundHead(), under({0, 1, 0}), 0.0);
  EXPECT_THAT(target.mri_T_target.rotation().col(1), EigenNear(Eigen::Vector3d(0, 0, 1), 0.02));
}

TEST(PlanTarget, RefusesAPointThatIsNotUnderTheScalp) {
  EXPECT_THROW(planTarget("far", roundHead(), Point<Mri>(400, 0, 0), 0.0), Error);
  EXPECT_THROW(planTarget("none", surface::ScalpSurface{}, Point<Mri>(0, 0, 0), 0.0), Error);
}

}  // namespace
}  // namespace facenav::guidance
