#include "facenav/plan/cortex_field.h"

#include <gmock/gmock.h>

#include "facenav/core/error.h"
#include "facenav/efield/built_in_coils.h"
#include "facenav/efield/primary_field.h"
#include "facenav/geometry/rotation.h"
#include "facenav/guidance/handle.h"
#include "facenav/plan/best_pose.h"
#include "facenav/volume/nifti.h"
#include "support/ball_case.h"
#include "support/refusal.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;
using testing::refusalOf;

/// The ball case: skin at 90 mm, brain of 40 mm, both about the origin.
class CortexFieldTest : public ::testing::Test {
 protected:
  CortexFieldTest()
      : store_(casefile::CaseStore::create(folder_.path() / "case", testing::ballWithBrain(), {}, false)),
        surfaces_(fieldSurfaces(store_)),
        planned_(plannedHead(store_)),
        coil_(efield::figureEight70()) {
    target_ = targetOverCortex(planned_, "top", Point<Mri>(0, 0, 40));
    head_ = headField(store_, surfaces_, coilPoseOf(target_));
  }
  testing::TemporaryFolder folder_;
  casefile::CaseStore store_;
  FieldSurfaces surfaces_;
  PlannedHead planned_;
  efield::CoilDipoles coil_;
  guidance::Target target_;
  std::unique_ptr<HeadField> head_;
};

TEST_F(CortexFieldTest, IsThatOfTheSphereInABall) {
  const auto result = fieldOnCortex(*head_, surfaces_, coil_, target_);
  EXPECT_EQ(head_->tier(), FieldTier::local_sphere);
  EXPECT_THAT(head_->inWords(), HasSubstr("sphere fitted to the skull under the coil"));
  const Eigen::Vector3d wanted = efield::sphereField(coil_, coilPoseOf(target_), Eigen::Vector3d::Zero(),
                                                     Eigen::Matrix3Xd(target_.cortex_point.mm))
                                     .col(0);
  EXPECT_LT((result.at_target - wanted).norm() / wanted.norm(), 0.02) << "the ball's voxels are 4 mm large";
  EXPECT_LT(result.at_target.dot(target_.mri_T_target.rotation().col(1)), -0.99 * result.at_target.norm())
      << "along the handle, -y";
  EXPECT_EQ(result.field.cols(), Eigen::Index(surfaces_.cortex.vertices_mm.size()));
  EXPECT_GE(result.peak, 0.97 * result.at_target.norm());
  EXPECT_LT(result.peak_distance_mm, 10) << "the ball has steps of 4 mm";
  EXPECT_LT(result.normal.off_radial_deg, 15) << "a ball has no sulci";
  EXPECT_LT(std::abs(result.along_normal), 0.15 * result.at_target.norm());
}

TEST_F(CortexFieldTest, FallsWithTheGap) {
  const double touching = fieldOnCortex(*head_, surfaces_, coil_, target_).at_target.norm();
  const auto above = guidance::withHairGap(target_, 5);
  EXPECT_LT(fieldOnCortex(*head_, surfaces_, coil_, above).at_target.norm(), 0.9 * touching);
}

TEST_F(CortexFieldTest, RegionsAreTheVoxelsAboveTheirShareOfTheMaximum) {
  const auto result = fieldOnCortex(*head_, surfaces_, coil_, target_);
  const auto label = [](const Point<Mri>& p) { return std::string(p.mm.x() < 0 ? "left" : "right"); };
  const auto regions = fieldRegions(*head_, surfaces_, coil_, target_, result.peak, label);
  const auto volume = fieldVolume(*head_, surfaces_, coil_, coilPoseOf(target_), 1);
  for (const auto& region : regions) {
    const auto count = std::count_if(volume.voxels.begin(), volume.voxels.end(),
                                     [&](float v) { return v >= region.share * result.peak; });
    EXPECT_NEAR(region.volume_ml, double(count) * volume.grid.voxelVolume_mm3() / 1000, 1e-6) << region.share;
    EXPECT_NEAR(region.by_label.at("left") + region.by_label.at("right"), region.volume_ml, 1e-9);
  }
  EXPECT_GT(regions[0].volume_ml, regions[1].volume_ml);
  EXPECT_GT(regions[1].volume_ml, regions[2].volume_ml);
  EXPECT_GT(regions[2].volume_ml, 0);
}

TEST_F(CortexFieldTest, ItsFilesCompareAsEqual) {
  for (const char* name : {"E.msh", "E.vtp"}) {
    const auto path = folder_.path() / name;
    writeField(*head_, surfaces_, coil_, target_, 66, path);
    const auto known = compareField(*head_, surfaces_, coil_, target_, path, 66);
    EXPECT_NEAR(known.relative_error, 0, 1e-6) << name;
    EXPECT_NEAR(known.peak_ratio, 1, 1e-6);
    EXPECT_EQ(known.peak_shift_mm, 0);
    EXPECT_EQ(known.points, int(surfaces_.cortex.vertices_mm.size()));
    const auto unknown = compareField(*head_, surfaces_, coil_, target_, path, {});
    EXPECT_TRUE(unknown.is_scaled);
    EXPECT_NEAR(unknown.scale, 66, 1e-3);
    EXPECT_NEAR(unknown.relative_error, 0, 1e-6);
    const auto half = compareField(*head_, surfaces_, coil_, target_, path, 33);
    EXPECT_NEAR(half.relative_error, 0.5, 1e-6);
    const auto weaker = compareField(*head_, surfaces_, coil_, guidance::withHairGap(target_, 10), path, 66);
    EXPECT_GT(weaker.relative_error, 0.1);
  }
}

TEST_F(CortexFieldTest, AFieldOfAnotherCortexIsRefused) {
  auto moved = surfaces_;
  for (auto& p : moved.cortex.vertices_mm) p += Eigen::Vector3d(60, 0, 0);
  const auto path = folder_.path() / "E.vtp";
  writeField(*head_, moved, coil_, target_, 1, path);
  EXPECT_THAT(refusalOf([&] { compareField(*head_, surfaces_, coil_, target_, path, 1); }),
              HasSubstr("another cortex"));
}

TEST_F(CortexFieldTest, TheNiftiHoldsTheStrengthInTheBrain) {
  const auto path = folder_.path() / "E.nii.gz";
  writeField(*head_, surfaces_, coil_, target_, 66, path);
  const auto read = volume::readNifti(path).volume;
  ASSERT_TRUE(read.grid.matches(surfaces_.brain_mask->grid));
  const Eigen::Vector3d voxel(25, 24, 32);
  const Eigen::Matrix3Xd place = read.grid.toMri(voxel).mm;
  EXPECT_NEAR(read.at(25, 24, 32), 66 * head_->at(coil_, coilPoseOf(target_), place).norm(), 1e-3);
  EXPECT_EQ(read.at(1, 1, 1), 0);
  EXPECT_THAT(refusalOf([&] { writeField(*head_, surfaces_, coil_, target_, 1, folder_.path() / "E.txt"); }),
              HasSubstr(".vtp, .msh, .nii"));
}

TEST_F(CortexFieldTest, TheBestPoseOverATargetIsAboveIt) {
  const auto here = bestPose(*head_, surfaces_, planned_, coil_, target_, FieldAim::strength);
  EXPECT_EQ(here.x_mm, 0);
  EXPECT_EQ(here.y_mm, 0);
  EXPECT_EQ(here.turned_deg, 0) << "in a sphere all angles are equal: the planned one stays";
  EXPECT_EQ(here.poses, 25 * 36);
  auto beside = guidance::movedOnHead(target_, *planned_.scalp, planned_.plate, 10, -5);
  beside.cortex_point = target_.cortex_point;
  const auto back = bestPose(*head_, surfaces_, planned_, coil_, beside, FieldAim::strength);
  EXPECT_NEAR(back.x_mm, -10, 5) << "the sphere that is fitted to the ball's voxels lies 1 to 2 mm beside";
  EXPECT_NEAR(back.y_mm, 5, 5);
  EXPECT_GT(back.best, 1.05 * back.planned);
  EXPECT_NEAR(back.best, here.best, 0.02 * here.best);
}

TEST_F(CortexFieldTest, TheBestPoseIsNeverWorseThanThePlannedOne) {
  // Pressed 3 mm into the skin, as an edited pose may be: every pose that rests on the head is weaker.
  auto pressed = target_;
  pressed.mri_T_target = RigidTransform<Mri, frames::Target>(
      target_.mri_T_target.quaternion(),
      target_.mri_T_target.translation_mm() + 3 * target_.mri_T_target.rotation().col(2));
  const auto best = bestPose(*head_, surfaces_, planned_, coil_, pressed, FieldAim::strength);
  EXPECT_GE(best.best, best.planned);
}

TEST_F(CortexFieldTest, TheBestAngleTurnsTheFieldAlongTheNormal) {
  // A bank of a sulcus at the target that faces at 60 degrees to the coil's y.
  auto bank = surfaces_;
  const Eigen::Vector3d normal = target_.mri_T_target.rotation() *
                                 Eigen::Vector3d(std::sin(60 * kRadPerDeg), std::cos(60 * kRadPerDeg), 0);
  bank.cortex.normals.assign(bank.cortex.vertices_mm.size(), normal);
  const auto result = fieldOnCortex(*head_, bank, coil_, target_);
  EXPECT_NEAR(std::abs(result.along_normal) / result.at_target.norm(), 0.5, 0.02);
  EXPECT_NEAR(result.normal.off_radial_deg, 90, 1);
  const auto best = bestPose(*head_, bank, planned_, coil_, target_, FieldAim::along_normal);
  EXPECT_NEAR(best.turned_deg, -60, 1e-9);
  EXPECT_NEAR(best.best, result.at_target.norm(), 0.02 * result.at_target.norm());
}

TEST_F(CortexFieldTest, DoseKeepsTheFieldOfTheHotspot) {
  EXPECT_NEAR(doseByField_pct(1.2, 0.8, 50), 75, 1e-12);
  EXPECT_NEAR(doseByField_pct(1.2, 0.3, 50), 200, 1e-12) << "more than the stimulator has: shown, not cut";
  EXPECT_THROW(doseByField_pct(1, 0, 50), Error);
}

TEST_F(CortexFieldTest, SaysWhatACaseLacks) {
  const auto bare = casefile::CaseStore::create(folder_.path() / "bare", testing::ballCase(), {}, false);
  EXPECT_THAT(refusalOf([&] { fieldSurfaces(bare); }), HasSubstr("no brain model"));
  EXPECT_THAT(refusalOf([&] { headField(store_, surfaces_, coilPoseOf(target_), FieldTier::three_shells); }),
              HasSubstr("three shells are not built"));
}

}  // namespace
}  // namespace facenav::steps
