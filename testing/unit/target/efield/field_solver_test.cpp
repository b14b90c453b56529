// The boundary elements against the closed form in balls of 642 vertices; the fine mesh is in
// sphere_accuracy_test.cpp.

#include "facenav/efield/field_solver.h"

#include <gtest/gtest.h>

#include "efield_scene.h"
#include "modes/coil_rows.h"
#include "support/refusal.h"

namespace facenav::efield::testing {
namespace {

using facenav::testing::refusalOf;

const FieldSolver& coarseBalls() {
  static const FieldSolver solver = [] {
    TaskMonitor monitor;
    return FieldSolver(balls(3), {}, monitor);
  }();
  return solver;
}

TEST(ClosedForm, GivesTheGoldenNumbers) {
  const Eigen::Matrix3Xd r = Vector3d(0, 30, 70);
  const Vector3d found = closedForm(oneDipole({0, 0, 100}, {1, 0, 0}), Pose(), r).col(0);
  EXPECT_NEAR(found.x(), 0, 1e-6);
  EXPECT_NEAR(found.y(), -22.780584, 1e-6);
  EXPECT_NEAR(found.z(), 9.763107, 1e-6);
}

TEST(FieldSolver, AgreesWithTheClosedFormByDepth) {
  Draw draw(3);
  const std::pair<double, double> kDepthAndMost[] = {{3, 0.010}, {6, 0.006}, {10, 0.006}, {20, 0.005}};
  for (int i = 0; i < 2; ++i) {
    const Pose pose = draw.pose(i);
    for (const auto& [depth_mm, most] : kDepthAndMost) {
      const auto points = draw.pointsUnder(pose, kInnerSkull_mm - depth_mm, 60);
      EXPECT_LT(relativeError(coarseBalls().fieldAt(figureEight(), pose, points),
                              closedForm(figureEight(), pose, points)),
                most)
          << depth_mm << " mm";
    }
  }
}

TEST(FieldSolver, HasNoRadialFieldInABall) {
  Draw draw(4);
  const Pose pose = draw.pose();
  const auto points = draw.pointsUnder(pose, 60, 60);
  const auto field = coarseBalls().fieldAt(figureEight(), pose, points);
  const double radial = (field.array() * points.array()).colwise().sum().abs().maxCoeff() / 60;
  EXPECT_LT(radial, 0.005 * field.colwise().norm().maxCoeff());
}

TEST(FieldSolver, IsZeroInTheMiddleOfABall) {
  Draw draw(5);
  const Pose pose = draw.pose();
  Eigen::Matrix3Xd points(3, 2);
  points << 0, 30 * -pose.rotation().col(2).x(), 0, 30 * -pose.rotation().col(2).y(), 0,
      30 * -pose.rotation().col(2).z();
  const auto field = coarseBalls().fieldAt(figureEight(), pose, points);
  EXPECT_LT(field.col(0).norm(), 0.005 * field.col(1).norm());
}

TEST(FieldSolver, DoesNotDependOnConductivityInABall) {
  TaskMonitor monitor;
  const FieldSolver other(balls(3), {0.4, 0.02, 0.25, 1.79}, monitor);
  Draw draw(6);
  const Pose pose = draw.pose();
  const auto points = draw.pointsUnder(pose, 66, 60);
  EXPECT_LT(relativeError(other.fieldAt(figureEight(), pose, points),
                          coarseBalls().fieldAt(figureEight(), pose, points)),
            0.009);  // each is 0.4 % off the closed form
}

TEST(FieldSolver, AFluidRoundTheBrainChangesNothingInABall) {
  HeadModel head = balls(3);
  head.brain = ball(72, 3);
  TaskMonitor monitor;
  const FieldSolver four(head, {}, monitor);
  EXPECT_EQ(four.innermost().vertices_mm, head.brain->vertices_mm);
  Draw draw(13);
  const Pose pose = draw.pose();
  const auto points = draw.pointsUnder(pose, 58, 60);
  EXPECT_LT(relativeError(four.fieldAt(figureEight(), pose, points), closedForm(figureEight(), pose, points)),
            0.012);
}

/// The flux through the coil of a current dipole in the brain, computed forwards: potentials on the
/// surfaces first.
TEST(FieldSolver, IsReciprocalToTheFluxOfACurrentInTheBrain) {
  const BoundarySystem& system = coarseBalls().system();
  const Vector3d r(10, -20, 50), p = Vector3d(0.6, 0.7, -0.4).normalized();
  Draw draw(7);
  const Pose pose = draw.pose();
  Eigen::MatrixXf potentials(system.size(), 1);
  for (Eigen::Index i = 0; i < system.size(); ++i) {
    const Vector3d to = system.vertices_mm.col(i) - r;
    potentials(i) = float(p.dot(to) / (4 * M_PI * to.squaredNorm() * to.norm()));
  }
  dense::solve(dense::viewOf(system.lu), system.pivots, dense::viewOf(potentials));
  const DipoleArray coil = dipolesAt(figureEight(), pose);
  double flux = fluxOf(system, coil).col(0).dot(potentials.col(0));
  for (Eigen::Index d = 0; d < coil.size(); ++d) {
    const Vector3d to = coil.positions_mm.col(d).cast<double>() - r, m = coil.moments.col(d).cast<double>();
    flux += m.dot(p.cross(to)) / (to.squaredNorm() * to.norm());
  }
  const Vector3d field = coarseBalls().fieldAt(figureEight(), pose, r).col(0);
  EXPECT_NEAR(field.dot(p), -1e5 * flux, 1e-3 * field.norm());
}

/// Compares B along each dipole of the coil, summed, with that from the coil's field (reciprocity).
TEST(FieldSolver, GivesTheFluxOfSarvasEquationInABall) {
  Draw draw(14);
  for (int i = 0; i < 3; ++i) {
    const Pose pose = draw.pose(i);
    const Vector3d source_mm = 60 * -pose.rotation().col(2), current_nAm = 10 * draw.direction();
    double flux = 0;  // B.m, in T A m2
    for (Eigen::Index d = 0; d < figureEight().positions_mm.cols(); ++d) {
      const Vector3d place_mm = pose.isometry() * Vector3d(figureEight().positions_mm.col(d));
      const Vector3d moment = pose.rotation() * figureEight().moments_Am2.col(d);
      flux += sarvasField(1e-3 * source_mm, 1e-9 * current_nAm, 1e-3 * place_mm).dot(moment);
    }
    const Vector3d field = coarseBalls().fieldAt(figureEight(), pose, source_mm).col(0);
    const double largest = 1e-9 * current_nAm.norm() * field.norm() / 1e6;
    EXPECT_NEAR(-1e-9 * current_nAm.dot(field) / 1e6, flux, 0.005 * largest) << "642 vertices a surface";
  }
}

TEST(FieldSolver, KeepsPointsInsideTheMesh) {
  const ShellMesh inner = ball(kInnerSkull_mm, 3);
  Eigen::Matrix3Xd points(3, 3);
  points.col(0) << 0, 0, 60;
  points.col(1) << 0, 0, 79;
  points.col(2) << 0, 85, 0;
  const ReachablePoints reachable = reachablePoints(inner, points);
  EXPECT_EQ(reachable.is_moved, (std::vector<bool>{false, true, true}));
  EXPECT_EQ(reachable.points_mm.col(0), points.col(0));
  EXPECT_NEAR(reachable.points_mm.col(1).norm(), kInnerSkull_mm - 0.4 * 11.0, 1.0);
  EXPECT_NEAR(reachable.points_mm.col(2).norm(), kInnerSkull_mm - 0.4 * 11.0, 1.0);
}

TEST(FieldSolver, RefusesASurfaceWithAHole) {
  HeadModel head = balls(1);
  head.outer_skull.triangles.conservativeResize(3, head.outer_skull.triangles.cols() - 1);
  TaskMonitor monitor;
  EXPECT_EQ(refusalOf([&] { FieldSolver(head, {}, monitor); }),
            "the surface 'outer skull' is not closed; the electric field needs a closed one");
  head.outer_skull = ball(kOuterSkull_mm, 1);
  head.outer_skull.triangles.row(0).swap(head.outer_skull.triangles.row(1));
  EXPECT_NE(refusalOf([&] { FieldSolver(head, {}, monitor); }).find("face inwards"), std::string::npos);
}

TEST(Icosphere, IsFinerAboveAndStaysASphere) {
  const ShellMesh graded = icosphere(3, 0.75);
  ASSERT_EQ(graded.vertices_mm.cols(), 642);
  EXPECT_NEAR(graded.vertices_mm.colwise().norm().minCoeff(), 1, 1e-12);
  const Eigen::VectorXd edges = vertexEdges_mm(graded), even = vertexEdges_mm(icosphere(3));
  Eigen::Index top = 0, bottom = 0;
  graded.vertices_mm.row(2).maxCoeff(&top);
  graded.vertices_mm.row(2).minCoeff(&bottom);
  EXPECT_NEAR(edges[top] / even.mean(), 0.75, 0.06);
  EXPECT_NEAR(edges[bottom] / even.mean(), 1 / 0.75, 0.12);
  requireClosed(graded, "ball");
}

TEST(GeodesicSphere, HasTheVerticesOfItsPieces) {
  for (const int parts : {1, 3, 12}) {
    const ShellMesh sphere = geodesicSphere(parts), graded = geodesicSphere(parts, 0.75);
    ASSERT_EQ(sphere.vertices_mm.cols(), 10 * parts * parts + 2);
    ASSERT_EQ(sphere.triangles.cols(), 20 * parts * parts);
    EXPECT_NEAR(sphere.vertices_mm.colwise().norm().minCoeff(), 1, 1e-12);
    EXPECT_NEAR(graded.vertices_mm.colwise().norm().minCoeff(), 1, 1e-12);
    for (const ShellMesh* mesh : {&sphere, &graded}) requireClosed(*mesh, "ball");
  }
  const Eigen::VectorXd edges = vertexEdges_mm(geodesicSphere(12));
  EXPECT_LT(edges.maxCoeff() / edges.minCoeff(), 1.3) << "about even";
  EXPECT_EQ(outerParts(4), 12);
  EXPECT_EQ(outerParts(2), 3);
  EXPECT_EQ(outerParts(0), 1);
}

TEST(LinearSolidAngles, AgreeWithASumOverSmallTriangles) {
  const Vector3d a(3, -1, 2), b(1, 4, 3), c(-2, 0, 2.5);
  const Vector3d normal = (b - a).cross(c - a).normalized();
  Vector3d sum = Vector3d::Zero();
  const int kParts = 400;
  const double area = 0.5 * (b - a).cross(c - a).norm() / (kParts * kParts);
  for (int i = 0; i < kParts; ++i)
    for (int j = 0; j + i < kParts; ++j)
      for (const double third : {1 / 3.0, 2 / 3.0}) {
        if (third > 0.5 && i + j + 2 > kParts) continue;
        const double s = (i + third) / kParts, t = (j + third) / kParts;
        const Vector3d place = a + s * (b - a) + t * (c - a), share(1 - s - t, s, t);
        sum += share * area * normal.dot(place) / std::pow(place.norm(), 3);
      }
  const Vector3d found = linearSolidAngles(a, b, c);
  EXPECT_LT((found - sum).norm(), 1e-5);
  EXPECT_EQ(linearSolidAngles(a, b, 0.5 * (a + b) - Vector3d(a + b)), Vector3d::Zero()) << "seen edge-on";
}

}  // namespace
}  // namespace facenav::efield::testing
