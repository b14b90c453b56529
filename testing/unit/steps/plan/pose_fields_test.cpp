#include "facenav/plan/pose_fields.h"

#include <gtest/gtest.h>

#include <cmath>

#include "facenav/casefile/threshold_file.h"
#include "facenav/efield/built_in_coils.h"
#include "facenav/plan/cortex_field.h"
#include "facenav/plan/plan_edits.h"
#include "facenav/plan/threshold_dose.h"
#include "facenav/prepare/case_field.h"
#include "support/ball_with_cortex.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

/// The ball case with a brain of 70 mm and a target over its top.
class PoseFieldsTest : public ::testing::Test {
 protected:
  PoseFieldsTest()
      : store_(casefile::CaseStore::create(folder_.path() / "case", testing::ballWithCortex(), {}, false)),
        top_(targetOverCortex(plannedHead(store_), "top", Point<Mri>(0, 0, 68))) {}

  PoseFields fields() const { return PoseFields(std::make_shared<const ReadHead>(store_), coil_); }
  /// Expects the field of headField at targets, and nearly its maximum on the whole cortex.
  void expectTheFieldOfTheCase() const {
    const auto made = fields();
    const auto surfaces = fieldSurfaces(store_);
    for (const double x_mm : {0.0, 15.0}) {
      guidance::Target target = top_;
      target.mri_T_target = RigidTransform<Mri, frames::Target>(
          top_.mri_T_target.quaternion(), top_.mri_T_target.translation_mm() + Eigen::Vector3d(x_mm, 0, 2));
      const auto pose = coilPoseOf(target);
      const auto model = headField(store_, surfaces, pose);
      const auto known = fieldOnCortex(*model, surfaces, coil_, target);
      const auto field = made.at(pose, target.cortex_point);
      EXPECT_NEAR(field.at_target.value(), known.at_target.norm(), 1e-5 * known.peak) << x_mm;
      EXPECT_NEAR(field.peak, known.peak, 0.03 * known.peak) << "of every second vertex or so";
      EXPECT_LT((field.peak_place.mm - known.peak_place.mm).norm(), 8) << x_mm;
      EXPECT_EQ(field.usual_error, model->usualError());
      EXPECT_EQ(made.tier(), model->tier());
    }
  }

  testing::TemporaryFolder folder_;
  casefile::CaseStore store_;
  guidance::Target top_;
  efield::CoilDipoles coil_ = efield::figureEight70();
};

TEST_F(PoseFieldsTest, GiveTheFieldOfTheCaseByTheSphere) {
  EXPECT_EQ(fields().tier(), FieldTier::local_sphere);
  expectTheFieldOfTheCase();
}

TEST_F(PoseFieldsTest, GiveTheFieldOfTheCaseByItsShells) {
  TaskMonitor monitor;
  buildField(store_, monitor);
  EXPECT_EQ(fields().tier(), FieldTier::three_shells);
  expectTheFieldOfTheCase();
}

TEST_F(PoseFieldsTest, TheMeasuredGapWeakensTheFieldAsInTheSphere) {
  const auto made = fields();
  auto lifted = top_;
  lifted.mri_T_target = RigidTransform<Mri, frames::Target>(
      top_.mri_T_target.quaternion(),
      top_.mri_T_target.translation_mm() - 5.0 * top_.mri_T_target.rotation().col(2));
  const double near = *made.at(coilPoseOf(top_), top_.cortex_point).at_target;
  const double far = *made.at(coilPoseOf(lifted), top_.cortex_point).at_target;
  EXPECT_NEAR(far / near, 0.81, 0.04) << "5 mm of lift take 19 % (resources/doc/field.md)";
}

TEST_F(PoseFieldsTest, TheRangeIsTheUsualErrorAndWhatAMovedCoilGives) {
  const auto made = fields();
  const auto pose = coilPoseOf(top_);
  const double here = *made.at(pose, top_.cortex_point).at_target;
  const auto sure = made.rangeAt(pose, top_.cortex_point, here, 0.28, {});
  EXPECT_NEAR(sure.low, 0.72 * here, 1e-9);
  EXPECT_NEAR(sure.high, 1.28 * here, 1e-9);
  // A perfect model whose coil may be 3 mm off: the coil that is 3 mm nearer or farther gives the ends.
  const auto moved = made.rangeAt(pose, top_.cortex_point, here, 0, {3, 0});
  double least = here, most = here;
  for (int axis = 0; axis < 3; ++axis)
    for (const double step_mm : {-3.0, 3.0}) {
      const RigidTransform<frames::Coil, frames::Coil> step(Eigen::Quaterniond::Identity(),
                                                            step_mm * Eigen::Vector3d::Unit(axis));
      const double there = *made.at(pose * step, top_.cortex_point).at_target;
      least = std::min(least, there), most = std::max(most, there);
    }
  EXPECT_NEAR(moved.low, least, 0.01 * here) << "the sphere is fitted anew there";
  EXPECT_NEAR(moved.high, most, 0.01 * here);
  EXPECT_LT(moved.low, 0.95 * here);
  const auto both = made.rangeAt(pose, top_.cortex_point, here, 0.28, {3, 5});
  EXPECT_LT(both.low, sure.low);
  EXPECT_GT(both.high, sure.high);
}

TEST_F(PoseFieldsTest, TheDoseFollowsFromTheNewestThresholdWhoseHotspotIsKnown) {
  EXPECT_FALSE(hotspotThreshold(store_.folder())) << "no search yet";
  auto hotspot = top_;
  hotspot.name = "M1 hand L";
  {
    auto file =
        casefile::ThresholdFile::begin(store_.folder(), stimulation::ThresholdMethod::bayes, "FDI", hotspot);
    auto state = thresholdAfter(stimulation::ThresholdMethod::bayes, {});
    while (!state.isDone()) {
      file.keep({{*state.next_pct, *state.next_pct >= 48}});
      state = thresholdAfter(stimulation::ThresholdMethod::bayes, file.kept().plain());
    }
    casefile::ThresholdFile::begin(store_.folder(), stimulation::ThresholdMethod::bayes, "FDI", top_);
  }
  const auto threshold = hotspotThreshold(store_.folder());
  ASSERT_TRUE(threshold) << "the newer one is not finished";
  EXPECT_EQ(threshold->hotspot.name, "M1 hand L");
  EXPECT_EQ(threshold->hotspot.mri_T_target.translation_mm(), hotspot.mri_T_target.translation_mm());
  EXPECT_NEAR(threshold->threshold_pct, 47.5, 2);
  const auto made = fields();
  const double there = *made.at(coilPoseOf(hotspot), hotspot.cortex_point).at_target;
  const auto dose = thresholdDose(made.head(), coil_, *threshold, 0.8 * there);
  EXPECT_NEAR(dose.output_pct, threshold->threshold_pct / 0.8, 1e-9);
  EXPECT_NEAR(dose.at_hotspot, there, 1e-12);
}

}  // namespace
}  // namespace facenav::steps
