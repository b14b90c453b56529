#include "facenav/guidance/handle.h"

#include <gtest/gtest.h>

#include "facenav/core/error.h"
#include "made_targets.h"
#include "support/matchers.h"

namespace facenav::guidance {
namespace {
using namespace guidance::testing;
using facenav::testing::EigenNear;

const Eigen::Vector3d kCentre_mm(12, -30, 25);

const surface::ScalpSurface& roundHead() {
  static const surface::ScalpSurface kHead = [] {
    surface::ScalpSurface scalp;
    scalp.mesh = sphere(kCentre_mm, 90, 180);  // facets of 1.6 mm
    return scalp;
  }();
  return kHead;
}

Target over(const Eigen::Vector3d& direction, double angle_deg, double gap_mm = 0) {
  return planTarget("spot", roundHead(), Point<Mri>(kCentre_mm + 70 * direction.normalized()), rad(angle_deg),
                    gap_mm);
}

double angle_deg(const Target& target) { return handleAngle(target, roundHead()).angle_rad * 180 / M_PI; }

const Eigen::Vector3d kForehead(0.1, 1, 0.1), kOcciput(-0.1, -1, 0.2), kVertex(0.05, 0, 1), kLeft(-1, 0, 0.1),
    kM1Left(-1, 0.2, 1), kM1Right(1, 0.2, 1);

TEST(HandleAngle, IsTheSignedAngleThatTheTargetWasPlannedWith) {
  for (const auto& place : {kForehead, kOcciput, kVertex, kLeft, kM1Left, kM1Right})
    for (const double planned_deg : {-170.0, -60.0, -45.0, -10.0, 0.0, 14.0, 45.0, 60.0, 90.0, 179.0})
      EXPECT_NEAR(angle_deg(over(place, planned_deg)), planned_deg, 1e-6) << place.transpose();
}

TEST(HandleAngle, IsMeasuredFromSuperiorOnlyOverForeheadAndOcciput) {
  for (const auto& place : {kForehead, kOcciput})
    EXPECT_EQ(handleAngle(over(place, 20), roundHead()).reference, HandleReference::superior);
  for (const auto& place : {kVertex, kLeft, kM1Left, kM1Right})
    EXPECT_EQ(handleAngle(over(place, 20), roundHead()).reference, HandleReference::anterior);
}

TEST(HairGap, IsTheOnePlanned) {
  EXPECT_NEAR(hairGap_mm(over(kM1Left, 45)), 0.0, 1e-9);
  EXPECT_NEAR(hairGap_mm(over(kForehead, -45, 4.5)), 4.5, 1e-9);
}

TEST(MovedAlongScalp, KeepsTheSignedAngleOfTheHandleGapDepthNameAndNote) {
  for (const auto& place : {kForehead, kOcciput, kVertex, kLeft, kM1Left, kM1Right})
    for (const double planned_deg : {-90.0, -45.0, -10.0, 0.0, 45.0, 120.0}) {
      Target target = over(place, planned_deg, 4.0);
      target.note = "hotspot";
      const Target moved = movedAlongScalp(target, roundHead(), 1, 0);
      EXPECT_NEAR(angle_deg(moved), planned_deg, 2.5) << place.transpose();
      EXPECT_NEAR(hairGap_mm(moved), 4.0, 1e-9);
      // On a ball of 90 mm; the cortex point lies at 70 mm and turns with the coil by the same angle.
      EXPECT_NEAR((moved.scalp_point.mm - target.scalp_point.mm).norm(), 1.0, 0.02);
      EXPECT_NEAR((moved.cortex_point.mm - target.cortex_point.mm).norm(), 70.0 / 90, 0.15)
          << "the ball's facets";
      EXPECT_NEAR((moved.cortex_point.mm - moved.scalp_point.mm).norm(), 20.0, 0.2);
      EXPECT_EQ(moved.name, "spot");
      EXPECT_EQ(moved.note, "hotspot");
    }
}

/// Displacement of the coil's centre, in its axes before the step.
Eigen::Vector3d stepOf(const Target& before, const Target& after) {
  return before.mri_T_target.rotation().transpose() *
         (after.mri_T_target.translation_mm() - before.mri_T_target.translation_mm());
}

TEST(MovedAlongScalp, StartsUnderTheCoilAlsoWhereItStandsBesideItsTarget) {
  for (const auto& place : {kForehead, kVertex, kLeft, kM1Right})
    for (const Eigen::Vector3d& beside_mm :
         {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(12, -7, 3), Eigen::Vector3d(-20, 5, -5)}) {
      Target target = over(place, 30);
      target.cortex_point.mm += target.mri_T_target.rotation() * beside_mm;
      for (const Eigen::Vector2d& way_mm :
           {Eigen::Vector2d(1, 0), Eigen::Vector2d(-1, 0), Eigen::Vector2d(0, 5), Eigen::Vector2d(3, -4)}) {
        const Target moved = movedAlongScalp(target, roundHead(), way_mm.x(), way_mm.y());
        EXPECT_THAT(Eigen::Vector2d(stepOf(target, moved).head<2>()), EigenNear(way_mm, 1e-6));
        const Eigen::Vector3d under = (target.mri_T_target.inverse() * target.cortex_point).mm;
        const Eigen::Vector3d under_then = (moved.mri_T_target.inverse() * moved.cortex_point).mm;
        EXPECT_THAT(under_then, EigenNear(under, 1e-6)) << "the target moves with its coil";
      }
    }
}

TEST(MovedAlongScalp, MeasuresALongWayOnTheSkin) {
  // A quarter of the way round the ball: the plate's centre turns about the ball's centre by 141 / 90 rad.
  const Target target = over(kVertex, 0);
  const Target moved = movedAlongScalp(target, roundHead(), 0, 141);
  const Eigen::Vector3d from = (target.scalp_point.mm - kCentre_mm).normalized();
  const Eigen::Vector3d to = (moved.scalp_point.mm - kCentre_mm).normalized();
  EXPECT_NEAR(std::acos(from.dot(to)), 141.0 / 90, 0.03);
  EXPECT_NEAR(to.dot(target.mri_T_target.rotation().col(0)), 0, 0.02) << "straight ahead";
}

TEST(MovedAlongScalp, NeverTurnsTheHandleRoundOnTheWayFromForeheadToCrown) {
  Target target = over({0, 1, 0}, 0.0);
  for (int step = 0; step < 60; ++step) {
    const Target moved = movedAlongScalp(target, roundHead(), 0, 1);
    const Eigen::Vector3d before = target.mri_T_target.rotation().col(1);
    EXPECT_GT(before.dot(moved.mri_T_target.rotation().col(1)), std::cos(rad(4))) << step;
    target = moved;
  }
  EXPECT_GT(target.cortex_point.mm.z(), kCentre_mm.z() + 40);    // it moved up
  EXPECT_NEAR(target.mri_T_target.rotation()(0, 1), 0.0, 0.05);  // and stayed in the mid-sagittal plane
}

TEST(HandleAngle, CanBeSetAnywhereAndKeepsPlaceAxisAndGap) {
  for (const auto& place : {kForehead, kOcciput, kVertex, kLeft, kM1Left, kM1Right})
    for (const double wanted_deg : {-180.0, -60.0, 0.0, 14.0, 45.0, 179.0}) {
      const Target before = over(place, 33, 4.5);
      const Target after = withHandleAngle(before, roundHead(), rad(wanted_deg));
      EXPECT_NEAR(std::remainder(angle_deg(after) - wanted_deg, 360.0), 0.0, 1e-6);
      EXPECT_THAT(after.mri_T_target.translation_mm(), EigenNear(before.mri_T_target.translation_mm(), 1e-9));
      EXPECT_NEAR(after.mri_T_target.rotation().col(2).dot(before.mri_T_target.rotation().col(2)), 1, 1e-9);
      EXPECT_NEAR(hairGap_mm(after), 4.5, 1e-9);
    }
  for (const double beyond_deg : {-181.0, 270.0, std::nan("")})
    EXPECT_THROW(withHandleAngle(over(kLeft, 0), roundHead(), rad(beyond_deg)), Error);
}

TEST(HairGap, CanBeSetAndMovesTheCoilAlongItsAxisOnly) {
  const Target before = over(kM1Left, -20, 2.0), after = withHairGap(before, 6.5);
  EXPECT_NEAR(hairGap_mm(after), 6.5, 1e-9);
  EXPECT_NEAR(angle_deg(after), -20, 1e-9);
  const Eigen::Vector3d z = before.mri_T_target.rotation().col(2);
  EXPECT_THAT(after.mri_T_target.translation_mm(),
              EigenNear(before.mri_T_target.translation_mm() - 4.5 * z, 1e-9));
  EXPECT_THAT(after.scalp_point.mm, EigenNear(before.scalp_point.mm, 0.0));
  for (const double beyond_mm : {-0.1, 20.1, std::nan("")})
    EXPECT_THROW(withHairGap(before, beyond_mm), Error);
}

TEST(CortexDepth, IsTheWayFromScalpToCortexAlongTheAxisWhateverTheGap) {
  EXPECT_NEAR(cortexDepth_mm(over(kM1Left, 45)), 20.0, 0.1);
  EXPECT_NEAR(cortexDepth_mm(over(kM1Left, 45, 4.0)), 20.0, 0.1);
  EXPECT_NEAR(cortexDepth_mm(withHairGap(over(kForehead, 45), 9.0)), 20.0, 0.1);
}

}  // namespace
}  // namespace facenav::guidance
