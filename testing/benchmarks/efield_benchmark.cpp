// The electric field of a figure-8 coil in three balls: error against the closed form and time, of the modes,
// of the direct solution and of the plain sphere, in one run. Prints Markdown tables.
// efield_benchmark [points, 20484]

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "facenav/efield/cortex_field.h"
#include "support/stopwatch.h"
#include "unit/target/efield/efield_scene.h"

using namespace facenav;
using namespace facenav::efield;
using namespace facenav::efield::testing;
using facenav::testing::oneCore_ms;
using facenav::testing::quantile;
using facenav::testing::wall_ms;

namespace {

Eigen::Matrix3Xd pointsBelow(Draw& draw, double least_mm, double most_mm, int count) {
  Eigen::Matrix3Xd points(3, count);
  for (int p = 0; p < count; ++p) {
    Vector3d towards = draw.direction();
    if (towards.z() < -0.3) towards.z() *= -1;
    points.col(p) = (kInnerSkull_mm - least_mm - (most_mm - least_mm) * p / count) * towards;
  }
  return points;
}

void printDepths(const FieldSolver& solver, Draw& draw, const std::vector<Pose>& poses) {
  std::printf("| below the inner skull | direct, mean | direct, worst |\n|---|---|---|\n");
  for (const double depth_mm : {2.0, 3.0, 4.0, 6.0, 10.0, 20.0}) {
    double sum = 0, worst = 0;
    for (const Pose& pose : poses) {
      const auto points = draw.pointsUnder(pose, kInnerSkull_mm - depth_mm, 200);
      const double error =
          relativeError(solver.fieldAt(figureEight(), pose, points), closedForm(figureEight(), pose, points));
      sum += error / double(poses.size()), worst = std::max(worst, error);
    }
    std::printf("| %.0f mm | %.2f %% | %.2f %% |\n", depth_mm, 100 * sum, 100 * worst);
  }
}

void printModes(const FieldSolver& solver, const Eigen::Matrix3Xd& points, const std::vector<Pose>& poses) {
  TaskMonitor monitor;
  const double start_ms = wall_ms(), processor_ms = processorTime_ms();
  const CortexField field = makeCortexField(solver, points, monitor);
  std::printf("\n%td points: modes made in %.1f s (processor %.1f s)\n\n", field.points_mm.cols(),
              1e-3 * (wall_ms() - start_ms), 1e-3 * (processorTime_ms() - processor_ms));
  const Eigen::Matrix3Xd places = field.points_mm.cast<double>();
  double worst_direct = 0, worst_truth = 0;
  for (const Pose& pose : poses) {
    const Eigen::Matrix3Xd fast = fieldAt(field, figureEight(), pose).cast<double>();
    worst_direct = std::max(worst_direct, relativeError(fast, solver.fieldAt(figureEight(), pose, places)));
    worst_truth = std::max(worst_truth, relativeError(fast, closedForm(figureEight(), pose, places)));
  }
  std::vector<double> times;
  for (int i = 0; i < 60; ++i)
    times.push_back(
        oneCore_ms([&] { fieldAt(field, figureEight(), poses[std::size_t(i) % poses.size()]); }, 1));
  const double direct_ms = oneCore_ms([&] { solver.fieldAt(figureEight(), poses[0], places); }, 1);
  const double sphere_ms = oneCore_ms([&] { closedForm(figureEight(), poses[0], places); }, 3);
  std::printf("| method | a pose, one core | worst error against the closed form |\n|---|---|---|\n");
  std::printf("| modes | %.2f ms (median) | %.2f %% (%.2f %% off the direct route) |\n", quantile(times, 0.5),
              100 * worst_truth, 100 * worst_direct);
  std::printf("| direct | %.0f ms | - |\n| closed form of the sphere | %.1f ms | 0 |\n", direct_ms,
              sphere_ms);
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 20484;
  std::printf(
      "## Electric field on the cortex: three balls of 2562, 1442 and 1442 vertices, figure-8 coil, 8 "
      "poses\n\n");
  TaskMonitor monitor;
  const double start_ms = wall_ms(), processor_ms = processorTime_ms();
  const FieldSolver solver(caseBalls(), {}, monitor);
  std::printf("equations solved in %.1f s (processor %.1f s)\n\n", 1e-3 * (wall_ms() - start_ms),
              1e-3 * (processorTime_ms() - processor_ms));
  Draw draw(1);
  std::vector<Pose> poses;
  for (int i = 0; i < 8; ++i) poses.push_back(draw.pose(i % 5));
  printDepths(solver, draw, poses);
  for (const int points : {count, 5000}) printModes(solver, pointsBelow(draw, 4, 30, points), poses);
}
