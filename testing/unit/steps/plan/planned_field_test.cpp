#include "facenav/plan/planned_field.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/prepare/case_field.h"
#include "support/ball_with_cortex.h"
#include "support/refusal.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;
using testing::refusalOf;

/// The ball case with a brain of 70 mm and a target over its top.
class PlannedFieldTest : public ::testing::Test {
 protected:
  PlannedFieldTest()
      : store_(casefile::CaseStore::create(folder_.path() / "case", testing::ballWithCortex(), {}, false)) {
    wanted_.target = targetOverCortex(plannedHead(store_), "top", Point<Mri>(0, 0, 68));
    wanted_.coil = "figure8-70";
  }
  testing::TemporaryFolder folder_;
  casefile::CaseStore store_;
  WantedField wanted_;
  TaskMonitor monitor_;
};

TEST_F(PlannedFieldTest, IsTheFieldOnTheCortexTimesTheRate) {
  const ReadHead head(store_);
  EXPECT_EQ(head.tier(), FieldTier::local_sphere);
  const auto pose = coilPoseOf(wanted_.target);
  const auto coil = efield::fieldCoil(wanted_.coil).dipoles;
  const auto known =
      fieldOnCortex(*headField(store_, head.surfaces(), pose), head.surfaces(), coil, wanted_.target);
  wanted_.rate.value = 66;
  wanted_.drawn = std::make_shared<const surface::TriangleMesh>(head.surfaces().cortex);
  const auto field = plannedField(head, wanted_, monitor_);
  EXPECT_EQ(field.rate_A_per_us, 66);
  EXPECT_NEAR(field.at_target, 66 * known.at_target.norm(), 1e-9);
  EXPECT_NEAR(field.peak, 66 * known.peak, 1e-9);
  EXPECT_NEAR(field.along_normal, 66 * std::abs(known.along_normal), 1e-9);
  ASSERT_EQ(field.strength.size(), head.surfaces().cortex.vertices_mm.size());
  EXPECT_NEAR(*std::max_element(field.strength.begin(), field.strength.end()), field.peak, 1e-4 * field.peak);
  // On another surface: the same field at its own vertices.
  auto above = head.surfaces().cortex;
  above.vertices_mm = {wanted_.target.cortex_point.mm};
  wanted_.drawn = std::make_shared<const surface::TriangleMesh>(above);
  EXPECT_NEAR(plannedField(head, wanted_, monitor_).strength.at(0), field.at_target, 1e-4 * field.at_target);
}

TEST_F(PlannedFieldTest, APercentageNeedsTheCoilsLargestRate) {
  const CurrentRate half{50, CurrentRate::Unit::output_pct};
  auto coil = efield::fieldCoil("round").dipoles;
  EXPECT_THAT(refusalOf([&] { inA_per_us(half, coil); }), HasSubstr("give the rate in A/us"));
  coil.largest_didt_A_per_us = 140;
  EXPECT_EQ(inA_per_us(half, coil), 70);
}

TEST_F(PlannedFieldTest, TheKeptShellsAreReadOnceForManyPoses) {
  buildField(store_, monitor_);
  const ReadHead head(store_);
  EXPECT_EQ(head.tier(), FieldTier::three_shells);
  for (const double x_mm : {0.0, 20.0}) {
    auto target = wanted_.target;
    target.mri_T_target = RigidTransform<Mri, frames::Target>(
        target.mri_T_target.quaternion(), target.mri_T_target.translation_mm() + Eigen::Vector3d(x_mm, 0, 2));
    const auto pose = coilPoseOf(target);
    const Eigen::Matrix3Xd place = target.cortex_point.mm;
    const auto coil = efield::fieldCoil(wanted_.coil).dipoles;
    const auto fresh = headField(store_, head.surfaces(), pose);
    EXPECT_EQ(head.near(pose)->at(coil, pose, place), fresh->at(coil, pose, place)) << x_mm;
  }
  const auto field = plannedField(head, wanted_, monitor_);
  EXPECT_EQ(field.tier, FieldTier::three_shells);
  EXPECT_NEAR(field.usual_error, 0.23, 1e-12);
}

TEST_F(PlannedFieldTest, AVoidModelIsReadOnceAndSaid) {
  EXPECT_FALSE(ReadHead(store_).isOutdated()) << "none was built";
  efield::writeCortexField({}, "made from other masks", fieldFile(store_));
  const ReadHead old(store_);
  EXPECT_EQ(old.tier(), FieldTier::local_sphere);
  EXPECT_TRUE(old.isOutdated());
  EXPECT_TRUE(old.isCurrent(store_)) << "poses need not read the case again";
  std::filesystem::last_write_time(
      fieldFile(store_), std::filesystem::last_write_time(fieldFile(store_)) + std::chrono::seconds(2));
  EXPECT_FALSE(old.isCurrent(store_)) << "another model was written";
  std::filesystem::remove(store_.folder() / "cortex.vtp");
  EXPECT_FALSE(ReadHead(store_).isOutdated()) << "no new one can be built";
}

TEST_F(PlannedFieldTest, WhatItReachesIsThatOfTheFieldAtItsRate) {
  const ReadHead head(store_);
  wanted_.rate.value = 66;
  wanted_.against = targetOverCortex(plannedHead(store_), "side", Point<Mri>(40, 0, 55));
  const auto field = plannedField(head, wanted_, monitor_);
  const auto reach = plannedReach(head, wanted_, {}, monitor_);
  ASSERT_TRUE(reach.regions);
  ASSERT_TRUE(reach.in_brain);
  const auto& strength = *reach.in_brain;
  const auto at = [&](const Eigen::Vector3d& p_mm) {
    return double(volume::sampleLinear(strength, strength.grid.toVoxel(Point<Mri>(p_mm))));
  };
  EXPECT_NEAR(
      at({0, 0, 62}),
      66 *
          [&] {
            const Eigen::Matrix3Xd place = Eigen::Vector3d(0, 0, 62);
            const auto pose = coilPoseOf(wanted_.target);
            return head.near(pose)->at(efield::fieldCoil(wanted_.coil).dipoles, pose, place).norm();
          }(),
      0.03 * field.peak)
      << "voxels of 4 mm";
  EXPECT_EQ(at({0, 0, 85}), 0) << "outside the brain";
  EXPECT_NEAR(reach.against->at_target, field.at_target, 1e-9);
  EXPECT_LT(reach.against->change(), -0.1);
  EXPECT_GT((*reach.regions)[0].volume_ml, (*reach.regions)[2].volume_ml);
  monitor_.cancel();
  EXPECT_THROW(plannedReach(head, wanted_, {}, monitor_), Cancelled);
}

TEST_F(PlannedFieldTest, TheModelWithTheFluidIsTheSurestAndSaysWhatTheFluidChanges) {
  const FieldMesh coarse{2, 1200};
  buildField(store_, monitor_, FieldTier::three_shells, coarse);
  const auto pose = coilPoseOf(wanted_.target);
  const auto surfaces = fieldSurfaces(store_);
  EXPECT_THAT(refusalOf([&] { headField(store_, surfaces, pose, FieldTier::four_shells); }),
              HasSubstr("four shells are not built"));
  buildField(store_, monitor_, FieldTier::four_shells, coarse);
  EXPECT_EQ(ReadHead(store_).tier(), FieldTier::four_shells);
  const auto four = headField(store_, surfaces, pose);
  EXPECT_EQ(four->tier(), FieldTier::four_shells);
  EXPECT_THAT(four->inWords(), HasSubstr("four shells with the fluid"));
  const auto three = headField(store_, surfaces, pose, FieldTier::three_shells);
  EXPECT_EQ(three->tier(), FieldTier::three_shells);
  EXPECT_LT(four->usualError(), three->usualError());
  EXPECT_EQ(plannedField(ReadHead(store_), wanted_, monitor_).tier, FieldTier::four_shells);
  const auto coil = efield::fieldCoil(wanted_.coil).dipoles;
  const auto change = compareModels(*four, *three, surfaces, coil, wanted_.target);
  const auto with = fieldOnCortex(*four, surfaces, coil, wanted_.target),
             without = fieldOnCortex(*three, surfaces, coil, wanted_.target);
  EXPECT_EQ(std::size_t(change.points), surfaces.cortex.vertices_mm.size());
  EXPECT_NEAR(change.relative_error, (with.field - without.field).norm() / without.field.norm(), 1e-9);
  EXPECT_NEAR(change.peak_ratio, with.peak / without.peak, 1e-9);
  EXPECT_NEAR(change.peak_shift_mm, (with.peak_place.mm - without.peak_place.mm).norm(), 1e-9);
  EXPECT_LT(change.relative_error, 0.5) << "a ball: the fluid changes nothing, the coarse meshes do";
  EXPECT_EQ(compareModels(*four, *four, surfaces, coil, wanted_.target).relative_error, 0);
}

TEST_F(PlannedFieldTest, ACancelledOneGivesNothing) {
  const ReadHead head(store_);
  monitor_.cancel();
  EXPECT_THROW(plannedField(head, wanted_, monitor_), Cancelled);
}

}  // namespace
}  // namespace facenav::steps
