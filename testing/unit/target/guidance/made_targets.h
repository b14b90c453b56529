#pragma once
// Targets and scalps with known geometry.

#include <cmath>

#include "facenav/guidance/guidance.h"
#include "facenav/surface/triangle_mesh.h"

namespace facenav::guidance::testing {

inline double rad(double angle_deg) { return angle_deg * M_PI / 180.0; }

/// Makes orthonormal axes from z and y given with few decimals.
template <class From>
RigidTransform<Mri, From> poseFrom(const Eigen::Vector3d& origin_mm, const Eigen::Vector3d& z,
                                   const Eigen::Vector3d& y) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear().col(2) = z.normalized();
  pose.linear().col(1) = (y - y.dot(z.normalized()) * z.normalized()).normalized();
  pose.linear().col(0) = pose.linear().col(1).cross(pose.linear().col(2));
  pose.translation() = origin_mm;
  return RigidTransform<Mri, From>::fromIsometry(pose);
}

/// Target of a coil flat on the vertex: z down into the head, handle towards the back of the head, cortex 20
/// mm below.
inline Target vertexTarget() {
  Target target;
  target.name = "vertex";
  target.mri_T_target = poseFrom<frames::Target>({0, 0, 100}, {0, 0, -1}, {0, 1, 0});
  target.cortex_point = Point<Mri>(0, 0, 80);
  target.scalp_point = Point<Mri>(0, 0, 100);
  return target;
}

/// The vertex target's pose after a motion in the target's own axes: first rotated, then shifted.
inline RigidTransform<Mri, Coil> coilAt(const Target& target, const Eigen::Vector3d& shift_mm,
                                        const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity()) {
  Eigen::Isometry3d offset = Eigen::Isometry3d::Identity();
  offset.linear() = rotation;
  offset.translation() = shift_mm;
  return target.mri_T_target * RigidTransform<frames::Target, Coil>::fromIsometry(offset);
}

inline Eigen::Matrix3d about(const Eigen::Vector3d& axis, double angle_deg) {
  return Eigen::AngleAxisd(rad(angle_deg), axis).toRotationMatrix();
}

/// A sphere about `centre`, outward triangles.
inline surface::TriangleMesh sphere(const Eigen::Vector3d& centre_mm, double radius_mm, int rows = 90) {
  surface::TriangleMesh mesh;
  const int columns = 2 * rows;
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const double phi = M_PI * i / rows, theta = 2 * M_PI * j / columns;
      const Eigen::Vector3d n(std::sin(phi) * std::cos(theta), std::sin(phi) * std::sin(theta),
                              std::cos(phi));
      mesh.vertices_mm.push_back(centre_mm + radius_mm * n);
      mesh.normals.push_back(n);
    }
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const int a = i * columns + j, b = i * columns + (j + 1) % columns;
      mesh.triangles.emplace_back(a, a + columns, b);
      mesh.triangles.emplace_back(b, a + columns, b + columns);
    }
  return mesh;
}

}  // namespace facenav::guidance::testing
