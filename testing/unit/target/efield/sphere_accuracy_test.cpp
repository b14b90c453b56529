// The goals of accuracy with the mesh that cases use: caseBalls() in efield_scene.h.

#include <gtest/gtest.h>

#include "efield_scene.h"
#include "facenav/efield/cortex_field.h"

namespace facenav::efield::testing {
namespace {

TEST(SphereAccuracy, OfTheFineMeshMeetsItsGoals) {
  TaskMonitor monitor;
  const FieldSolver solver(caseBalls(), {}, monitor);
  Draw draw(12);
  // Without modes.
  const std::pair<double, double> kDepthAndMost[] = {
      {2, 0.002}, {3, 0.002}, {4, 0.002}, {6, 0.002}, {10, 0.002}};
  std::vector<Pose> poses;
  for (int i = 0; i < 4; ++i) poses.push_back(draw.pose(i));
  for (const auto& [depth_mm, most] : kDepthAndMost) {
    std::vector<Eigen::Matrix3Xd> under;
    for (const Pose& pose : poses) under.push_back(draw.pointsUnder(pose, kInnerSkull_mm - depth_mm, 300));
    double square = 0, size = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const auto truth = closedForm(figureEight(), poses[i], under[i]);
      square += (solver.fieldAt(figureEight(), poses[i], under[i]) - truth).squaredNorm();
      size += truth.squaredNorm();
    }
    EXPECT_LT(std::sqrt(square / size), most) << depth_mm << " mm";
  }
  Eigen::Matrix3Xd points(3, 5000);
  for (int p = 0; p < 5000; ++p) {
    Vector3d towards = draw.direction();
    if (towards.z() < -0.3) towards.z() *= -1;
    points.col(p) = (kInnerSkull_mm - 4 - 26.0 * p / 5000) * towards;
  }
  const CortexField field = makeCortexField(solver, points, monitor);
  for (const Pose& pose : poses) {
    const Eigen::Matrix3Xd fast = fieldAt(field, figureEight(), pose).cast<double>();
    EXPECT_LT(relativeError(fast, closedForm(figureEight(), pose, field.points_mm.cast<double>())), 0.005);
    EXPECT_LT(relativeError(fast, solver.fieldAt(figureEight(), pose, field.points_mm.cast<double>())),
              0.003);
  }
}

}  // namespace
}  // namespace facenav::efield::testing
