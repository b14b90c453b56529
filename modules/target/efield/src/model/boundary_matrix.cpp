#include <Eigen/Geometry>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/parallel_for.h"
#include "model/boundary_system.h"

namespace facenav::efield {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::Vector3i;
using kernels::kCorners;
using kernels::kLanes;

// Triangles farther than this many of their longest edges are summed at kCorners places: the rule is exact
// to degree 4 (Dunavant 1985, Int J Numer Methods Eng 21:1129).
constexpr double kFarEdges = 4.0;
constexpr double kOuter = 0.091576213509770743, kOuterWeight = 0.10995174365532187;
constexpr double kInner = 0.44594849091596489, kInnerWeight = 0.22338158967801147;

/// Barycentric coordinates of the sampled places.
Eigen::Matrix<double, 3, kCorners> sampledPlaces() {
  Eigen::Matrix<double, 3, kCorners> places;
  for (int c = 0; c < 3; ++c) {
    places.col(c).setConstant(kOuter);
    places(c, c) = 1 - 2 * kOuter;
    places.col(3 + c).setConstant(kInner);
    places(c, 3 + c) = 1 - 2 * kInner;
  }
  return places;
}

/// All triangles of all shells, for the kernel, with their corners in double precision.
struct Triangles {
  std::vector<kernels::FarTriangle> far;
  Eigen::Matrix3Xd vertices;
  std::vector<double> step;  // per vertex: conductivity inside minus outside of its shell
  std::vector<double> mean;  // and their mean
  float shares[kCorners][3];
};

kernels::FarTriangle farTriangle(const Eigen::Matrix3d& corners, const Vector3i& numbers) {
  static const auto kPlaces = sampledPlaces();
  kernels::FarTriangle triangle;
  const Eigen::Matrix<float, 3, kCorners> at = (corners * kPlaces).cast<float>();
  for (int c = 0; c < kCorners; ++c)
    for (int axis = 0; axis < 3; ++axis) triangle.at[c][axis] = at(axis, c);
  const Vector3d across = 0.5 * (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
  const Vector3d centre = corners.rowwise().mean();
  double longest = 0;
  for (int c = 0; c < 3; ++c) longest = std::max(longest, (corners.col(c) - corners.col((c + 1) % 3)).norm());
  for (int axis = 0; axis < 3; ++axis) {
    triangle.across[axis] = float(across[axis]);
    triangle.centre[axis] = float(centre[axis]);
    triangle.corner[axis] = numbers[axis];
  }
  triangle.reach_mm = float(kFarEdges * longest);
  return triangle;
}

Triangles trianglesOf(const std::vector<Shell>& shells) {
  Triangles all;
  Index vertices = 0;
  for (const Shell& shell : shells) vertices += shell.mesh.vertices_mm.cols();
  all.vertices.resize(3, vertices);
  Index first = 0;
  for (const Shell& shell : shells) {
    const ShellMesh& mesh = shell.mesh;
    all.vertices.middleCols(first, mesh.vertices_mm.cols()) = mesh.vertices_mm;
    for (const auto triangle : mesh.triangles.colwise()) {
      Eigen::Matrix3d corners;
      for (int c = 0; c < 3; ++c) corners.col(c) = mesh.vertices_mm.col(triangle[c]);
      all.far.push_back(farTriangle(corners, Vector3i(triangle.array() + int(first))));
    }
    first += mesh.vertices_mm.cols();
    all.step.resize(std::size_t(first), shell.inside - shell.outside);
    all.mean.resize(std::size_t(first), (shell.inside + shell.outside) / 2);
  }
  const auto places = sampledPlaces();
  for (int c = 0; c < kCorners; ++c)
    for (int v = 0; v < 3; ++v)
      all.shares[c][v] = float(places(v, c) * (c < 3 ? kOuterWeight : kInnerWeight));
  return all;
}

/// Solid angles of all triangles from kLanes vertices, summed by corner.
class RowBlock {
 public:
  explicit RowBlock(const Triangles& all)
      : all_(all), sums_(std::size_t(all.vertices.cols()) * kLanes), near_(all.far.size()) {}

  /// Writes the rows `first` .. of the matrix.
  void write(Index first, double deflation, Eigen::MatrixXf& matrix) {
    const int count = int(std::min<Index>(kLanes, all_.vertices.cols() - first));
    sumFar(first, count);
    for (std::size_t t = 0; t < near_.size(); ++t)
      for (unsigned lanes = near_[t], lane = 0; lanes; lanes >>= 1, ++lane)
        if ((lanes & 1) && int(lane) < count) addNear(all_.far[t].corner, first + lane, int(lane));
    double rows[kLanes] = {};
    for (Index j = 0; j < all_.vertices.cols(); ++j) {
      const double factor = -all_.step[std::size_t(j)] / (4 * M_PI);
      for (int l = 0; l < count; ++l) {
        const double value = j == first + l ? 0.0 : factor * sums_[std::size_t(j * kLanes + l)];
        rows[l] += value;
        matrix(first + l, j) = float(value + deflation);
      }
    }
    // An equal potential everywhere solves the equations without a source, so that each row sums to 0. This
    // gives the diagonal the true solid angle at a vertex.
    for (int l = 0; l < count; ++l) matrix(first + l, first + l) = float(deflation - rows[l]);
  }

 private:
  void sumFar(Index first, int count) {
    std::fill(sums_.begin(), sums_.end(), 0.f);
    float place[3][kLanes];
    for (int l = 0; l < kLanes; ++l)
      for (int axis = 0; axis < 3; ++axis)
        place[axis][l] = float(all_.vertices(axis, first + std::min(l, count - 1)));
    kernels::kernel().far({place[0], place[1], place[2], all_.far.data(), std::ptrdiff_t(all_.far.size()),
                           all_.shares, sums_.data(), near_.data()});
  }
  void addNear(const std::int32_t* corner, Index row, int lane) {
    if (corner[0] == row || corner[1] == row || corner[2] == row) return;  // seen edge-on
    const Vector3d eye = all_.vertices.col(row);
    const Vector3d angles =
        linearSolidAngles(all_.vertices.col(corner[0]) - eye, all_.vertices.col(corner[1]) - eye,
                          all_.vertices.col(corner[2]) - eye);
    for (int v = 0; v < 3; ++v)
      sums_[std::size_t(corner[v]) * kLanes + std::size_t(lane)] += float(angles[v]);
  }

  const Triangles& all_;
  std::vector<float> sums_;
  std::vector<std::uint16_t> near_;
};

}  // namespace

Vector3d linearSolidAngles(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d corners[3] = {a, b, c};
  const Vector3d across = (b - a).cross(c - a);
  const double twice_area = across.norm();
  const Vector3d normal = across / twice_area;
  const double height = a.dot(normal);
  if (std::abs(height) < 1e-9 * std::sqrt(twice_area)) return Vector3d::Zero();
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double angle =
      2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + la * b.dot(c) + lb * a.dot(c) + lc * a.dot(b));
  // Integral of 1 / distance along each edge, times the edge's outward normal in the plane.
  Vector3d around = Vector3d::Zero();
  const double lengths[3] = {la, lb, lc};
  for (int e = 0; e < 3; ++e) {
    const Vector3d &from = corners[e], &to = corners[(e + 1) % 3];
    const Vector3d along = (to - from).normalized();
    // Of the two equal forms the one without a difference of nearly equal numbers.
    const double sign = from.dot(along) + to.dot(along) < 0 ? -1 : 1;
    const double begin = lengths[e] + sign * from.dot(along),
                 end = lengths[(e + 1) % 3] + sign * to.dot(along);
    around += sign * std::log(end / begin) * along.cross(normal);
  }
  Vector3d shares;
  for (int v = 0; v < 3; ++v) {
    const Vector3d &next = corners[(v + 1) % 3], &last = corners[(v + 2) % 3];
    const Vector3d slope = normal.cross(last - next) / twice_area;
    shares[v] = next.cross(last).dot(normal) / twice_area * angle - height * slope.dot(around);
  }
  return shares;
}

Eigen::MatrixXf boundaryMatrix(const std::vector<Shell>& shells, double deflation, TaskMonitor& monitor) {
  const Triangles all = trianglesOf(shells);
  const Index size = all.vertices.cols(), blocks = (size + kLanes - 1) / kLanes;
  Eigen::MatrixXf matrix(size, size);
  const std::size_t cores = coreCount();
  std::vector<RowBlock> workers(cores, RowBlock(all));
  parallelFor(std::size_t(blocks), cores, [&](std::size_t block, std::size_t worker) {
    if (worker == 0) monitor.report("electric field: equations", double(block) / double(blocks));
    workers[worker].write(Index(block) * kLanes, deflation, matrix);
  });
  return matrix;
}

}  // namespace facenav::efield
