// Why does the field with the fluid (tier 2) depend on the fineness of the brain's mesh? Three solutions of
// one case: a coarse brain; the same surface with each triangle divided into four, so that only quadrature
// and unknowns change; and a brain of as many vertices made from the cortex anew, so that the surface
// changes. Prints a Markdown table. fluid_mesh_benchmark CASE [vertices of the fine brains, 10000]

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "facenav/efield/brain_surface.h"
#include "facenav/efield/built_in_coils.h"
#include "facenav/efield/field_solver.h"
#include "facenav/efield/head_model.h"
#include "facenav/prepare/case_field.h"
#include "facenav/surface/closest_point.h"
#include "support/stopwatch.h"

using namespace facenav;
using Eigen::Vector3d;
using CoilPose = RigidTransform<Mri, frames::Coil>;

namespace {

constexpr double kBelow_mm = 3;   // of the points below the cortex
constexpr double kInside_mm = 2;  // of the points within both surfaces: nearer the solver has its own error
constexpr double kReach_mm = 60;
constexpr std::size_t kMostPoints = 1500;

/// Returns the same surface with each triangle divided into four.
efield::ShellMesh divided(const efield::ShellMesh& mesh) {
  std::vector<Vector3d> vertices;
  for (Eigen::Index i = 0; i < mesh.vertices_mm.cols(); ++i) vertices.emplace_back(mesh.vertices_mm.col(i));
  std::map<std::pair<int, int>, int> middles;
  const auto middleOf = [&](int a, int b) {
    const auto [at, is_new] = middles.emplace(std::minmax(a, b), int(vertices.size()));
    if (is_new) vertices.push_back((vertices[std::size_t(a)] + vertices[std::size_t(b)]) / 2);
    return at->second;
  };
  efield::ShellMesh result;
  result.triangles.resize(3, 4 * mesh.triangles.cols());
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Eigen::Vector3i v = mesh.triangles.col(t);
    const int ab = middleOf(v[0], v[1]), bc = middleOf(v[1], v[2]), ca = middleOf(v[2], v[0]);
    result.triangles.col(4 * t) << v[0], ab, ca;
    result.triangles.col(4 * t + 1) << ab, v[1], bc;
    result.triangles.col(4 * t + 2) << ca, bc, v[2];
    result.triangles.col(4 * t + 3) << ab, bc, ca;
  }
  result.vertices_mm =
      Eigen::Map<const Eigen::Matrix3Xd>(vertices[0].data(), 3, Eigen::Index(vertices.size()));
  return result;
}

surface::TriangleMesh triangles(const efield::ShellMesh& mesh) {
  surface::TriangleMesh result;
  for (Eigen::Index i = 0; i < mesh.vertices_mm.cols(); ++i)
    result.vertices_mm.emplace_back(mesh.vertices_mm.col(i));
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    result.triangles.emplace_back(mesh.triangles.col(t));
  return result;
}

/// Coils 4 mm over the scalp, in directions over the upper head.
std::vector<CoilPose> posesOver(const efield::ShellMesh& scalp) {
  const Vector3d middle = scalp.vertices_mm.rowwise().mean();
  std::vector<CoilPose> poses;
  for (const Vector3d& towards : {Vector3d(0, 0, 1), Vector3d(-0.7, 0, 0.7), Vector3d(0.6, 0.4, 0.7),
                                  Vector3d(-0.5, 0.7, 0.5), Vector3d(0.5, -0.5, 0.7)}) {
    Eigen::Index at = 0;
    Eigen::VectorXd along(scalp.vertices_mm.cols());
    for (Eigen::Index i = 0; i < along.size(); ++i)
      along[i] = (scalp.vertices_mm.col(i) - middle).normalized().dot(towards.normalized());
    along.maxCoeff(&at);
    const Vector3d out = (scalp.vertices_mm.col(at) - middle).normalized();
    const Vector3d y = out.cross(out.unitOrthogonal()).normalized();
    Eigen::Matrix3d axes;
    axes << y.cross(-out), y, -out;
    poses.emplace_back(Eigen::Quaterniond(axes), Vector3d(scalp.vertices_mm.col(at)) + 4 * out);
  }
  return poses;
}

/// Points below the cortex that lie within both surfaces.
Eigen::Matrix3Xd pointsWithin(const surface::TriangleMesh& cortex, const efield::ShellMesh& a,
                              const efield::ShellMesh& b, const std::vector<CoilPose>& poses) {
  const surface::ClosestPoint in_a(triangles(a)), in_b(triangles(b));
  std::vector<Vector3d> found;
  for (const std::size_t i : steps::fieldVertices(cortex)) {
    const Point<Mri> p(cortex.vertices_mm[i] - kBelow_mm * cortex.normals[i]);
    bool is_near = false;
    for (const auto& pose : poses) is_near |= (p.mm - pose.translation_mm()).norm() < kReach_mm;
    if (!is_near) continue;
    const auto to_a = in_a.nearest(p), to_b = in_b.nearest(p);
    if (to_a.is_outside || to_b.is_outside || std::min(to_a.distance_mm, to_b.distance_mm) < kInside_mm)
      continue;
    found.push_back(p.mm);
  }
  const std::size_t step = std::max<std::size_t>(1, found.size() / kMostPoints);
  Eigen::Matrix3Xd points(3, Eigen::Index((found.size() + step - 1) / step));
  for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) = found[std::size_t(i) * step];
  return points;
}

using Fields = std::vector<Eigen::Matrix3Xd>;

Fields solved(efield::HeadModel head, const efield::ShellMesh& brain, const Eigen::Matrix3Xd& points,
              const std::vector<CoilPose>& poses) {
  TaskMonitor monitor;
  head.brain = brain;
  const double start_ms = processorTime_ms();
  const efield::FieldSolver solver(std::move(head), {}, monitor);
  Fields fields;
  for (const auto& pose : poses) fields.push_back(solver.fieldAt(efield::figureEight70(), pose, points));
  std::printf("%td vertices: %.0f s of processor time\n", brain.vertices_mm.cols(),
              1e-3 * (processorTime_ms() - start_ms));
  return fields;
}

/// Relative error of one pose's field at the points near the coil.
double difference(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b, const Eigen::Matrix3Xd& points,
                  const CoilPose& pose) {
  double squares = 0, all = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    if ((points.col(i) - pose.translation_mm()).norm() > kReach_mm) continue;
    squares += (a.col(i) - b.col(i)).squaredNorm();
    all += b.col(i).squaredNorm();
  }
  return std::sqrt(squares / all);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::printf("left out: give a case folder\n"), 0;
  const auto store = casefile::CaseStore::open(argv[1]);
  const int most = argc > 2 ? std::atoi(argv[2]) : 10000;
  const auto cortex = store.cortex();
  const auto mask = store.brainMask();
  if (!cortex || !mask) return std::printf("the case has no cortex\n"), 1;
  const auto head = efield::buildHeadModel(*mask, store.headMask(), store.scalp().mesh);
  const auto coarse = efield::brainSurface(cortex->mesh, head.inner_skull, {most / 4});
  const auto same = divided(coarse);
  const auto fine = efield::brainSurface(cortex->mesh, head.inner_skull, {most});
  const auto poses = posesOver(head.scalp);
  const auto points = pointsWithin(cortex->mesh, coarse, fine, poses);
  std::printf("%td points, at least %.0f mm within the surfaces\n", points.cols(), kInside_mm);
  const Fields by_coarse = solved(head, coarse, points, poses), by_same = solved(head, same, points, poses),
               by_fine = solved(head, fine, points, poses);
  std::printf(
      "\n| pose | same surface, four times the triangles | other surface, as many vertices "
      "|\n|---|---|---|\n");
  for (std::size_t p = 0; p < poses.size(); ++p)
    std::printf("| %zu | %.1f %% | %.1f %% |\n", p + 1,
                100 * difference(by_coarse[p], by_same[p], points, poses[p]),
                100 * difference(by_same[p], by_fine[p], points, poses[p]));
}
