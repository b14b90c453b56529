#include "facenav/interop/axes.h"

#include <gtest/gtest.h>

#include "facenav/interop/brainsight_errors.h"
#include "interop_fixtures.h"

namespace facenav::interop {
namespace {

using testing::truth;

constexpr CoilAxes kAll[] = {CoilAxes::facenav, CoilAxes::brainsight, CoilAxes::localite, CoilAxes::softaxic,
                             CoilAxes::invesalius};

TEST(Axes, AreRightHandedInEveryProgram) {
  for (const auto axes : kAll) EXPECT_NEAR(axesOf(axes).determinant(), 1.0, 1e-12);
}

TEST(Axes, ReadingUndoesWriting) {
  const Eigen::Matrix4d ours = truth().at("M1 hand L").matrix();
  for (const auto axes : kAll)
    EXPECT_NEAR((toFaceNav(fromFaceNav(ours, axes), axes) - ours).cwiseAbs().maxCoeff(), 0.0, 1e-12);
}

/// The pose "M1 hand L" as other code wrote it: columns of its rotation.
TEST(Axes, GiveThePublishedNumbersInBothDirections) {
  const Eigen::Matrix4d ours = truth().at("M1 hand L").matrix();
  Eigen::Matrix3d brainsight, localite, softaxic;
  brainsight << 0.6088, 0.4031, -0.6833, -0.6088, 0.7896, -0.0766, 0.5087, 0.4626, 0.7261;
  localite << 0.683268, -0.403131, -0.608794, 0.076554, -0.789626, 0.608794, -0.726143, -0.462575, -0.508665;
  softaxic << 0.403131, 0.608794, 0.683268, 0.789626, -0.608794, 0.0765535, 0.462575, 0.508665, -0.726143;
  const std::pair<CoilAxes, Eigen::Matrix3d> kPublished[] = {
      {CoilAxes::brainsight, brainsight}, {CoilAxes::localite, localite}, {CoilAxes::softaxic, softaxic}};
  for (const auto& [axes, theirs] : kPublished) {
    const Eigen::Matrix3d written = fromFaceNav(ours, axes).topLeftCorner<3, 3>();
    EXPECT_NEAR((written - theirs).cwiseAbs().maxCoeff(), 0.0, 6e-5);
    Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
    pose.topLeftCorner<3, 3>() = theirs;
    const Eigen::Matrix3d read = toFaceNav(pose, axes).topLeftCorner<3, 3>();
    EXPECT_NEAR((read - ours.topLeftCorner<3, 3>()).cwiseAbs().maxCoeff(), 0.0, 6e-5);
  }
}

RigidTransform<Mri, Coil> fromBrainsight(const Eigen::Vector3d& centre, const Eigen::Vector3d& y,
                                         const Eigen::Vector3d& z) {
  Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
  pose.topLeftCorner<3, 3>() << y.cross(z), y, z;
  pose.topRightCorner<3, 1>() = centre;
  return soundPose(toFaceNav(pose, CoilAxes::brainsight), nullptr);
}

/// A sample of a published recording (resources/doc/formats.md, 3 decimals).
TEST(BrainsightErrors, AreThoseOfAPublishedSample) {
  const auto target = fromBrainsight({-37.524, -11.972, 57.554}, {.467, .774, .427}, {-.493, -.172, .853});
  const auto sample = fromBrainsight({-39.498, -12.015, 62.760}, {.430, .812, .395}, {-.547, -.115, .829});
  const auto errors = brainsightErrors(sample, target);
  EXPECT_NEAR(errors.distance_mm, 5.568, 2e-3);
  EXPECT_NEAR(errors.target_mm, 1.348, 1e-2);
  EXPECT_NEAR(errors.angular_deg, 4.702, 0.05);
  EXPECT_NEAR(std::abs(errors.twist_deg), 3.474, 0.05);
}

/// The four columns of samples that other code wrote, with tilts up to 12 degrees.
TEST(BrainsightErrors, AreThoseOfTheMadeSamples) {
  const auto head = testing::madeHead();
  const auto file = testing::readChecked(testing::made("brainsight_v14_samples.txt"), head);
  int compared = 0;
  for (const auto& item : file.items) {
    if (item.kind != Kind::pulse) continue;
    const auto errors = brainsightErrors(*item.mri_T_coil, *testing::itemNamed(file, item.target).mri_T_coil);
    EXPECT_NEAR(errors.distance_mm, std::stod(item.values.at("Dist. to Target")), 3e-4) << item.name;
    EXPECT_NEAR(errors.target_mm, std::stod(item.values.at("Target Error")), 1e-3) << item.name;
    EXPECT_NEAR(errors.angular_deg, std::stod(item.values.at("Angular Error")), 7e-3) << item.name;
    EXPECT_NEAR(errors.twist_deg, std::stod(item.values.at("Twist Error")), 7e-3) << item.name;
    ++compared;
  }
  EXPECT_EQ(compared, 12);
}

}  // namespace
}  // namespace facenav::interop
