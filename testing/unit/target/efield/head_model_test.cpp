// The three surfaces from masks: balls with known radii, and heads that cannot give them.

#include "facenav/efield/head_model.h"

#include <gtest/gtest.h>

#include <functional>

#include "efield_scene.h"
#include "model/radial_shell.h"
#include "support/ball_mesh.h"
#include "support/refusal.h"

namespace facenav::efield::testing {
namespace {

using facenav::testing::ballMesh;
using facenav::testing::refusalOf;
using Inside = std::function<bool(const Vector3d&)>;

volume::Mask maskOf(const Inside& inside, int size = 72, double lowest_mm = -106.5) {
  volume::Mask mask;
  mask.grid.size = {size, size, size};
  mask.grid.mri_from_voxel.linear() *= 3.0;
  mask.grid.mri_from_voxel.translation().setConstant(lowest_mm);
  for (int k = 0; k < size; ++k)
    for (int j = 0; j < size; ++j)
      for (int i = 0; i < size; ++i) mask.voxels.push_back(inside(mask.grid.toMri(Vector3d(i, j, k)).mm));
  return mask;
}
Inside inBall(double radius_mm, const Vector3d& middle = Vector3d::Zero()) {
  return [=](const Vector3d& p) { return (p - middle).norm() < radius_mm; };
}
double meanRadius(const ShellMesh& mesh) { return mesh.vertices_mm.colwise().norm().mean(); }

TEST(HeadModel, OfBallsHasTheirRadii) {
  const HeadModel head = buildHeadModel(maskOf(inBall(72)), maskOf(inBall(92)), ballMesh(92, 90, 120), 3);
  EXPECT_NEAR(meanRadius(head.inner_skull), 72 + 3, 0.6);
  EXPECT_NEAR(meanRadius(head.outer_skull), 72 + 3 + 6, 0.6);
  EXPECT_NEAR(meanRadius(head.scalp), 92, 0.3);
  EXPECT_GT(gaps_mm(head.inner_skull, head.outer_skull).minCoeff(), kLeastGap_mm);
  EXPECT_GT(gaps_mm(head.outer_skull, head.scalp).minCoeff(), kLeastGap_mm);
  for (const ShellMesh* mesh : {&head.inner_skull, &head.outer_skull, &head.scalp})
    requireClosed(*mesh, "ball");
}

TEST(RadialShell, InOtherDirectionsIsTheSameSurface) {
  RadialShell shell{Vector3d(3, -2, 5), icosphere(4, 0.75), {}};
  const auto radius_mm = [](const auto& d) { return 80 + 5 * d.x() - 4 * d.y() * d.z(); };
  shell.radius_mm.resize(shell.directions.vertices_mm.cols());
  for (Eigen::Index i = 0; i < shell.radius_mm.size(); ++i)
    shell.radius_mm[i] = radius_mm(shell.directions.vertices_mm.col(i));
  const RadialShell coarser = inDirections(shell, geodesicSphere(12, 0.75));
  ASSERT_EQ(coarser.radius_mm.size(), 1442);
  EXPECT_EQ(coarser.middle, shell.middle);
  for (Eigen::Index i = 0; i < coarser.radius_mm.size(); ++i)
    EXPECT_NEAR(coarser.radius_mm[i], radius_mm(coarser.directions.vertices_mm.col(i)), 0.02);
  const RadialShell same = inDirections(shell, shell.directions);
  EXPECT_LT((same.radius_mm - shell.radius_mm).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(HeadModel, OfASmallHeadStaysNested) {
  const HeadModel head = buildHeadModel(maskOf(inBall(55)), maskOf(inBall(64)), {}, 3);
  EXPECT_NEAR(meanRadius(head.outer_skull) - meanRadius(head.inner_skull), 0.4 * 6, 0.5);
  EXPECT_GE(gaps_mm(head.inner_skull, head.outer_skull).minCoeff(), kLeastGap_mm);
  EXPECT_GE(gaps_mm(head.outer_skull, head.scalp).minCoeff(), kLeastGap_mm);
}

TEST(HeadModel, FillsFissuresAndVentricles) {
  const Inside brain = inBall(72), ventricle = inBall(15),
               fissure = [](const Vector3d&p) { return std::abs(p.x()) < 3 && p.z() > 20; };
  const auto mask = maskOf([=](const Vector3d& p) { return brain(p) && !ventricle(p) && !fissure(p); });
  const HeadModel head = buildHeadModel(mask, maskOf(inBall(92)), {}, 3);
  EXPECT_NEAR(head.inner_skull.vertices_mm.colwise().norm().minCoeff(), 75, 3);
}

TEST(HeadModel, ANeckCutByTheScanIsClosedThere) {
  const Inside skull = inBall(90),
               neck = [](const Vector3d&p) { return p.z() < 0 && p.head<2>().norm() < 55; };
  const HeadModel head = buildHeadModel(
      maskOf(inBall(70)), maskOf([=](const Vector3d& p) { return skull(p) || neck(p); }), {}, 3);
  requireClosed(head.scalp, "scalp");
  EXPECT_GT(head.scalp.vertices_mm.row(2).minCoeff(), -110) << "a voxel below the scan";
}

TEST(HeadModel, OfAChildHasItsRadii) {
  // One year old: 0.8 of an adult's head.
  const HeadModel head = buildHeadModel(maskOf(inBall(58)), maskOf(inBall(73)), ballMesh(73, 90, 120), 3);
  EXPECT_NEAR(meanRadius(head.inner_skull), 58 + 3, 0.6);
  EXPECT_NEAR(meanRadius(head.outer_skull), 61 + 0.4 * 12, 0.6) << "at most 40 % of the way to the skin";
  EXPECT_NEAR(meanRadius(head.scalp), 73, 0.3);
}

TEST(HeadModel, BridgesHolesInTheBrainMask) {
  // A grid of holes of 4 mm radius every 16 mm, some of them open to the outside.
  const Inside brain = inBall(72), hole = [](const Vector3d&p) {
    const Vector3d cell = (p / 16).array() - (p / 16).array().round();
    return 16 * cell.norm() < 4;
  };
  const auto mask = maskOf([=](const Vector3d& p) { return brain(p) && !hole(p); });
  const HeadModel head = buildHeadModel(mask, maskOf(inBall(92)), {}, 3);
  EXPECT_NEAR(meanRadius(head.inner_skull), 75, 0.8);
  EXPECT_NEAR(head.inner_skull.vertices_mm.colwise().norm().minCoeff(), 75, 2.5);
}

TEST(HeadModel, ALesionThatIsLeftOutOfTheMaskIsBridgedOrFollowed) {
  // Lost tissue at the surface, filled by fluid and left out of the brain mask: 18 mm across. The skull goes
  // over it, as the closing by 10 mm bridges it.
  const Inside brain = inBall(72), small = inBall(9, {0, 0, 66}), wide = inBall(30, {0, 0, 66});
  const HeadModel bridged = buildHeadModel(maskOf([=](const Vector3d& p) { return brain(p) && !small(p); }),
                                           maskOf(inBall(92)), {}, 3);
  EXPECT_GT(bridged.inner_skull.vertices_mm.row(2).maxCoeff(), 72);
  // A wide one (60 mm) is taken as the brain's shape: the model is built, and its skull follows the mask.
  const HeadModel dented = buildHeadModel(maskOf([=](const Vector3d& p) { return brain(p) && !wide(p); }),
                                          maskOf(inBall(92)), {}, 3);
  for (const HeadModel* head : {&bridged, &dented}) {
    EXPECT_GE(gaps_mm(head->inner_skull, head->outer_skull).minCoeff(), kLeastGap_mm);
    EXPECT_GE(gaps_mm(head->outer_skull, head->scalp).minCoeff(), kLeastGap_mm);
  }
}

TEST(HeadModel, AHeadCutAboveTheBrainIsRefusedInOneLine) {
  // The scan ends 2 mm above the brain: skin and skull of the vertex are not in it.
  volume::Mask brain = maskOf(inBall(70, {0, 0, -30})), head = maskOf(inBall(90, {0, 0, -30}));
  for (auto* mask : {&brain, &head}) {  // keep what lies below z = 42 mm
    const int kept = 50;
    mask->grid.size[2] = kept;
    mask->voxels.resize(std::size_t(72) * 72 * kept);
  }
  const std::string words = refusalOf([&] { buildHeadModel(brain, head, {}, 2); });
  EXPECT_NE(words.find("cuts the head beside the brain"), std::string::npos) << words;
  EXPECT_EQ(words.find('\n'), std::string::npos);
}

TEST(HeadModel, SaysWhatIsMissing) {
  const volume::Mask head = maskOf(inBall(92));
  const auto refusal = [&](const Inside& brain, const volume::Mask& skin) {
    return refusalOf([&] { buildHeadModel(maskOf(brain), skin, {}, 2); });
  };
  EXPECT_NE(refusal([](const Vector3d&) { return false; }, head).find("no brain mask"), std::string::npos);
  EXPECT_NE(refusal([](const Vector3d& p) { return p.norm() < 70 && std::abs(p.z()) > 8; }, head)
                .find("several parts"),
            std::string::npos);
  EXPECT_NE(
      refusal([](const Vector3d& p) { return p.norm() < 70 && p.norm() > 60; }, head).find("holes or gaps"),
      std::string::npos);
  EXPECT_NE(refusal(inBall(91), head).find("reaches the skin"), std::string::npos);
  EXPECT_NE(refusal(inBall(70, {0, 0, 45}), head).find("cuts the brain"), std::string::npos);
  EXPECT_NE(refusal(inBall(70), maskOf(inBall(150))).find("cuts the head"), std::string::npos);
}

}  // namespace
}  // namespace facenav::efield::testing
