// The goals of accuracy of four shells: 10,242 vertices of the brain, somewhat fewer than cases have, and the
// other surfaces as in cases. In balls against the closed form, which does not depend on the fluid; in a
// bumpy ellipsoid, where it does, a mesh of half that fineness against this one.

#include <gtest/gtest.h>

#include "efield_scene.h"

namespace facenav::efield::testing {
namespace {

constexpr double kBrain_mm = 76;

TEST(FluidAccuracy, InBallsMeetsItsGoals) {
  HeadModel head = caseBalls();
  head.brain = ball(kBrain_mm, 5, 0.75);
  TaskMonitor monitor;
  const FieldSolver solver(head, {}, monitor);
  Draw draw(12);
  for (const auto& [depth_mm, most] :
       {std::pair{1.4, 0.01}, {2.0, 0.01}, {3.0, 0.01}, {4.0, 0.005}, {6.0, 0.005}, {10.0, 0.005}})
    for (int i = 0; i < 2; ++i) {
      const Pose pose = draw.pose(i);
      const auto points = draw.pointsUnder(pose, kBrain_mm - depth_mm, 100);
      EXPECT_LT(
          relativeError(solver.fieldAt(figureEight(), pose, points), closedForm(figureEight(), pose, points)),
          most)
          << depth_mm << " mm";
    }
}

/// Radius of a brain with bumps in a direction, mm.
double bumpy_mm(const Vector3d& d) {
  return 70 +
         4 * (std::sin(9 * d.x() + 1) * std::sin(8 * d.y() + 2) + std::sin(10 * d.z()) * std::sin(7 * d.x()));
}
ShellMesh stretched(ShellMesh mesh) {
  mesh.vertices_mm.row(0) *= 0.9;
  mesh.vertices_mm.row(1) *= 1.1;
  return mesh;
}

TEST(FluidAccuracy, AgainstTwiceTheFinenessIsSomeTwoPercent) {
  TaskMonitor monitor;
  std::vector<FieldSolver> solvers;
  for (const int more : {0, 1}) {
    ShellMesh brain = icosphere(4 + more, 0.75);
    for (auto vertex : brain.vertices_mm.colwise()) vertex *= bumpy_mm(vertex);
    HeadModel head = balls(3 + more, 0.75);
    for (ShellMesh* mesh : {&head.scalp, &head.outer_skull, &head.inner_skull}) *mesh = stretched(*mesh);
    head.brain = stretched(brain);
    solvers.emplace_back(std::move(head), Conductivities{}, monitor);
  }
  Draw draw(12);
  for (const auto& [depth_mm, most] : {std::pair{1.4, 0.022}, {2.0, 0.022}, {4.0, 0.017}, {10.0, 0.01}}) {
    double square = 0, size = 0;
    for (int i = 0; i < 4; ++i) {
      const Pose pose = draw.pose(8);
      Eigen::Matrix3Xd points = draw.pointsUnder(pose, 1, 150);
      for (auto point : points.colwise()) point *= bumpy_mm(point) - depth_mm;
      points = stretched({points, {}}).vertices_mm;
      const auto fine = solvers[1].fieldAt(figureEight(), pose, points);
      square += (solvers[0].fieldAt(figureEight(), pose, points) - fine).squaredNorm();
      size += fine.squaredNorm();
    }
    EXPECT_LT(std::sqrt(square / size), most) << depth_mm << " mm";
  }
}

}  // namespace
}  // namespace facenav::efield::testing
