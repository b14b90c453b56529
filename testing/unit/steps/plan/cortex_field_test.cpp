#include "facenav/plan/cortex_field.h"

#include <gmock/gmock.h>

#include "facenav/core/error.h"
#include "facenav/efield/built_in_coils.h"
#include "facenav/efield/primary_field.h"
#include "facenav/geometry/rotation.h"
#include "facenav/guidance/handle.h"
#include "facenav/plan/best_pose.h"
#include "facenav/plan/field_region.h"
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
  TaskMonitor monitor_;
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
  const auto in_brain = fieldInBrain(*head_, surfaces_, coil_, target_, result, monitor_, label);
  const auto& regions = in_brain.regions;
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
  // Slices show the same values, on the same voxels.
  const Eigen::Vector3d p = volume.grid.toMri(Eigen::Vector3d(25, 24, 32)).mm;
  const auto& strength = *in_brain.strength;
  EXPECT_NEAR(volume::sampleLinear(strength, strength.grid.toVoxel(Point<Mri>(p))), volume.at(25, 24, 32),
              1e-5);
  // The brain's hull, a ball of 40 mm: the cap above a share has an area of less than half the ball.
  for (const auto& region : regions) {
    EXPECT_GT(region.area_mm2, 0);
    EXPECT_LT(region.area_mm2, 0.5 * 4 * M_PI * 42 * 42);
  }
  EXPECT_GT(regions[0].area_mm2, regions[1].area_mm2);
  EXPECT_GT(regions[1].area_mm2, regions[2].area_mm2);
}

TEST(FieldArea, IsThatOfACapOfABall) {
  // Strength falls with height on a ball of 50 mm: what lies above z = 30 mm is a cap of 2 pi 50 (50 - 30)
  // mm2.
  const auto ball = testing::ballMesh(50.0, 90, 120);
  Eigen::VectorXd height(Eigen::Index(ball.vertices_mm.size()));
  for (Eigen::Index i = 0; i < height.size(); ++i) height[i] = ball.vertices_mm[std::size_t(i)].z();
  EXPECT_NEAR(areaAbove_mm2(ball, height, 30), 2 * M_PI * 50 * 20, 0.005 * 2 * M_PI * 50 * 20);
  EXPECT_NEAR(areaAbove_mm2(ball, height, -60), 4 * M_PI * 2500, 0.005 * 4 * M_PI * 2500);
  EXPECT_EQ(areaAbove_mm2(ball, height, 51), 0);
}

TEST_F(CortexFieldTest, AnotherPoseIsComparedOnTheSameCortex) {
  const auto same = comparePoses(*head_, *head_, surfaces_, coil_, target_, target_);
  EXPECT_NEAR(same.change(), 0, 1e-12);
  EXPECT_NEAR(same.correlation, 1, 1e-12);
  EXPECT_EQ(same.peak_shift_mm, 0);
  // In a sphere a coil that is 5 mm higher gives a weaker field of nearly the same shape.
  const auto above = guidance::withHairGap(target_, 5);
  const auto higher = comparePoses(*head_, *head_, surfaces_, coil_, target_, above);
  const double at_target = fieldOnCortex(*head_, surfaces_, coil_, above).at_target.norm();
  EXPECT_NEAR(higher.other_at_target, at_target, 1e-12);
  EXPECT_NEAR(higher.change(), at_target / higher.at_target - 1, 1e-12);
  EXPECT_LT(higher.change(), -0.1);
  EXPECT_GT(higher.correlation, 0.99);
  // Turned by a quarter about the ball's centre: target and maximum move by 40 sqrt(2) mm.
  const auto side = targetOverCortex(planned_, "side", Point<Mri>(40, 0, 0));
  const auto moved = comparePoses(*head_, *head_, surfaces_, coil_, target_, side);
  EXPECT_LT(moved.change(), -0.3);
  EXPECT_NEAR(moved.peak_shift_mm, 40 * std::sqrt(2), 12) << "the ball has steps of 4 mm";
  EXPECT_NEAR(moved.other_at_its_own, moved.at_target, 0.1 * moved.at_target);
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

/// A sphere about the ball's centre.
class BallField : public HeadField {
 public:
  FieldTier tier() const override { return FieldTier::local_sphere; }
  std::string inWords() const override { return "the ball"; }
  double usualError() const override { return 0; }
  Eigen::Matrix3Xd at(const efield::CoilDipoles& coil, const CoilPose& mri_T_coil,
                      const Eigen::Matrix3Xd& points_mm) const override {
    return efield::sphereField(coil, mri_T_coil, Eigen::Vector3d::Zero(), points_mm);
  }
};

// 5 mm on the skin change the field at 50 mm of depth by 0.3 % at least, so the plate must not stand on
// facets.
TEST_F(CortexFieldTest, TheBestPoseOverATargetIsAboveIt) {
  auto fine = *planned_.scalp;
  fine.mesh = testing::ballMesh(90.0, 180, 240);
  planned_.scalp = std::make_shared<const surface::ScalpSurface>(fine);
  const BallField ball;
  const auto target = targetOverCortex(planned_, "top", Point<Mri>(0, 0, 40));
  const auto here = bestPose(ball, surfaces_, planned_, coil_, target, FieldAim::strength);
  EXPECT_EQ(here.x_mm, 0);
  EXPECT_EQ(here.y_mm, 0);
  EXPECT_EQ(here.turned_deg, 0) << "in a sphere all angles are equal: the planned one stays";
  EXPECT_EQ(here.poses, 25 * 36);
  auto beside = guidance::movedOnHead(target, *planned_.scalp, planned_.plate, 10, -5);
  beside.cortex_point = target.cortex_point;
  const auto back = bestPose(ball, surfaces_, planned_, coil_, beside, FieldAim::strength);
  // The coil stands 11.2 mm of arc beside its target on a ball of 90 mm. The place over the target lies at
  // (-9.95, 4.97) mm in its axes, and gives 3.5 % more by the closed form.
  EXPECT_NEAR(back.x_mm, -9.95, 0.1);
  EXPECT_NEAR(back.y_mm, 4.97, 0.1);
  const auto& from = beside.mri_T_target;
  const Eigen::Vector3d moved_mm =
      from.rotation().transpose() * (back.target.mri_T_target.translation_mm() - from.translation_mm());
  EXPECT_NEAR(back.x_mm, moved_mm.x(), 1e-9) << "from the planned pose to the best one";
  EXPECT_NEAR(back.y_mm, moved_mm.y(), 1e-9);
  EXPECT_NEAR(back.best / back.planned, 1.035, 0.005);
  EXPECT_NEAR(back.best, here.best, 0.002 * here.best);
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
