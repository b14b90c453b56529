#pragma once
// Shapes: closed triangle meshes of simple solids, with flat normals, for the coil, its plate and other
// objects of the room.

#include <Eigen/Geometry>

#include "facenav/surface/triangle_mesh.h"

namespace facenav::room {

surface::TriangleMesh box(const Eigen::Vector3d& low_mm, const Eigen::Vector3d& high_mm);
/// Cylinder along z from z0 to z1.
surface::TriangleMesh cylinder(const Eigen::Vector2d& centre_mm, double radius_mm, double z0_mm,
                               double z1_mm);
/// Ellipsoid with smooth normals.
surface::TriangleMesh ellipsoid(const Eigen::Vector3d& centre_mm, const Eigen::Vector3d& radii_mm,
                                int rings = 48);
/// Bar of square section between two points.
surface::TriangleMesh bar(const Eigen::Vector3d& from_mm, const Eigen::Vector3d& to_mm, double width_mm);

surface::TriangleMesh joined(const surface::TriangleMesh& a, const surface::TriangleMesh& b);
surface::TriangleMesh moved(const Eigen::Isometry3d& pose, surface::TriangleMesh mesh);

}  // namespace facenav::room
