#include "head_frame.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "facenav/anatomy/head_norms.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/normal_equations.h"
#include "facenav/surface/closest_point.h"

namespace facenav::surface {
namespace {

using Eigen::Vector3d;

struct SymmetryPlane {
  Vector3d normal = Vector3d::UnitX();
  double offset_mm = 0.0;  // distance of the plane from the centroid
  Vector3d mirrored(const Vector3d& p) const { return p - 2 * (normal.dot(p) - offset_mm) * normal; }
};

/// Points of the skin down to a head's height below the vertex: shoulders and neck are not symmetric.
std::vector<Vector3d> samplesOf(const TriangleMesh& scalp) {
  constexpr std::size_t kCount = 1500;
  double top_mm = -1e9;
  for (const auto& v : scalp.vertices_mm) top_mm = std::max(top_mm, v.z());
  std::vector<Vector3d> samples;
  const std::size_t step = std::max<std::size_t>(1, scalp.vertices_mm.size() / kCount);
  for (std::size_t v = 0; v < scalp.vertices_mm.size(); v += step)
    if (scalp.vertices_mm[v].z() > top_mm - anatomy::kHeadHeight_mm) samples.push_back(scalp.vertices_mm[v]);
  return samples;
}

/// One Gauss-Newton step of the plane's two angles and offset; returns the step's length (rad and mm / 100).
double improve(SymmetryPlane& plane, const std::vector<Vector3d>& points, const Vector3d& centroid,
               const ClosestPoint& skin) {
  struct Pair {
    Vector3d jacobian;
    double residual_mm;
  };
  const Vector3d u = plane.normal.unitOrthogonal(), v = plane.normal.cross(u);
  std::vector<Pair> pairs;
  std::vector<double> sizes;
  for (const Vector3d& sample : points) {
    const Vector3d p = sample - centroid, q = plane.mirrored(p);
    const SurfacePoint near = skin.nearest(Point<Mri>(centroid + q));
    const Vector3d& m = near.normal.v;
    const double beside = plane.normal.dot(p) - plane.offset_mm;
    const auto turn = [&](const Vector3d& dn) { return -2 * m.dot(dn.dot(p) * plane.normal + beside * dn); };
    pairs.push_back({{turn(u), turn(v), 2 * m.dot(plane.normal)}, m.dot(centroid + q - near.point.mm)});
    sizes.push_back(near.distance_mm);
  }
  const double scale_mm = std::max(0.5, 2 * upperMedian(sizes));
  Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double w = 1 / (1 + (sizes[i] / scale_mm) * (sizes[i] / scale_mm));
    normal_matrix += w * pairs[i].jacobian * pairs[i].jacobian.transpose();
    right -= w * pairs[i].jacobian * pairs[i].residual_mm;
  }
  const Vector3d step = solveSymmetric(normal_matrix, right);
  if (!step.allFinite()) return 0;
  plane.normal = (plane.normal + step[0] * u + step[1] * v).normalized();
  plane.offset_mm += step[2];
  return std::abs(step[0]) + std::abs(step[1]) + std::abs(step[2]) / 100;
}

}  // namespace

Eigen::Isometry3d symmetryFrame(const TriangleMesh& scalp) {
  const auto points = samplesOf(scalp);
  Vector3d centroid = Vector3d::Zero();
  for (const auto& p : points) centroid += p / double(points.size());
  const ClosestPoint skin(scalp);
  SymmetryPlane plane;
  for (int i = 0; i < 25; ++i)
    if (improve(plane, points, centroid, skin) < 1e-4) break;
  if (plane.normal.x() < 0) plane = {-plane.normal, -plane.offset_mm};
  const Vector3d x = plane.normal;
  const Vector3d y = (Vector3d::UnitY() - x.y() * x).normalized();
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() << x.transpose(), y.transpose(), x.cross(y).transpose();
  frame.translation() = -frame.linear() * (centroid + plane.offset_mm * x);
  return frame;
}

Eigen::Isometry3d pitched(const Eigen::Isometry3d& frame, const Vector3d& forward_head) {
  const double angle_rad = std::atan2(forward_head.z(), forward_head.y());
  return Eigen::Isometry3d(Eigen::AngleAxisd(-angle_rad, Vector3d::UnitX())) * frame;
}

}  // namespace facenav::surface
