#include <cmath>
#include <limits>

#include "facenav/anatomy/brain_norms.h"
#include "facenav/geometry/nearest_on_triangle.h"
#include "facenav/guidance/target.h"
#include "tangent_directions.h"

namespace facenav::guidance {
namespace {

Eigen::Vector3d nearestOnScalp(const surface::TriangleMesh& mesh, const Eigen::Vector3d& p_mm) {
  Eigen::Vector3d nearest = Eigen::Vector3d::Zero();
  double best_mm2 = std::numeric_limits<double>::infinity();
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices_mm[triangle[0]], &b = mesh.vertices_mm[triangle[1]],
                          &c = mesh.vertices_mm[triangle[2]];
    const Eigen::Vector3d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    if ((p_mm - p_mm.cwiseMax(low).cwiseMin(high)).squaredNorm() >= best_mm2)
      continue;  // the bounding box is already too far
    const Eigen::Vector3d candidate = nearestOnTriangle(p_mm, a, b, c).point;
    const double distance_mm2 = (candidate - p_mm).squaredNorm();
    if (distance_mm2 < best_mm2) best_mm2 = distance_mm2, nearest = candidate;
  }
  return nearest;
}

/// Axes of the coil: z inwards, y at the angle from the reference in the tangent plane.
Eigen::Matrix3d coilAxes(const TangentDirections& directions, const Eigen::Vector3d& z,
                         double handle_angle_rad) {
  Eigen::Matrix3d axes;
  axes.col(2) = z;
  axes.col(1) =
      std::cos(handle_angle_rad) * directions.forward + std::sin(handle_angle_rad) * directions.medial;
  axes.col(0) = axes.col(1).cross(z);
  return axes;
}

}  // namespace

Target planTarget(const std::string& name, const surface::ScalpSurface& scalp, const Point<Mri>& cortex_point,
                  double handle_angle_rad, double gap_mm) {
  if (scalp.mesh.triangles.empty()) throw Error("no target can be planned: the scalp surface is empty");
  const Eigen::Vector3d scalp_mm = nearestOnScalp(scalp.mesh, cortex_point.mm);
  const double depth_mm = (cortex_point.mm - scalp_mm).norm();
  if (!anatomy::kTargetDepth.contains(depth_mm))
    throw Error("no target can be planned: the cortex point lies " + std::to_string(int(depth_mm)) +
                    " mm from the scalp",
                "target " + name, "choose a point on the cortex");
  const Eigen::Vector3d z = (cortex_point.mm - scalp_mm) / depth_mm;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = coilAxes(tangentDirections(scalp.mesh, z, cortex_point), z, handle_angle_rad);
  pose.translation() = scalp_mm - gap_mm * z;
  return {name, RigidTransform<Mri, frames::Target>::fromIsometry(pose), cortex_point, Point<Mri>(scalp_mm),
          ""};
}

}  // namespace facenav::guidance
