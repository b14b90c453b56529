#pragma once
// The skin under a plate: heights over the plate's plane, and the plane that rests on them.

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "facenav/guidance/coil_plate.h"
#include "facenav/surface/triangle_mesh.h"

namespace facenav::guidance {

/// A place over the plate's plane: x and y in it (mm), height along the coil's -z.
using OverPlate = Eigen::Vector3d;

/// Radius of the circle about the coil's centre that holds the outline.
double radius_mm(const CoilPlate& plate);
bool isInside(const std::vector<Eigen::Vector2d>& outline, const Eigen::Vector2d& p);

/// The part of the mesh with a corner within `radius_mm` of `centre_mm`; without normals.
surface::TriangleMesh partWithin(const surface::TriangleMesh& mesh, const Eigen::Vector3d& centre_mm,
                                 double radius_mm);

/// Vertices of the skin within the outline, in the axes of a coil at `pivot`. `reach_mm` below the highest
/// are left out: the other side of the head.
std::vector<OverPlate> skinUnder(const surface::TriangleMesh& skin, const CoilPlate& plate,
                                 const Eigen::Matrix3d& axes, const Eigen::Vector3d& pivot_mm);

/// The highest place of the skin within the outline, triangles cut by it included; nothing without skin.
std::optional<double> highest(const surface::TriangleMesh& skin, const CoilPlate& plate,
                              const Eigen::Matrix3d& axes, const Eigen::Vector3d& pivot_mm);

/// The outermost skin on the axis; nothing where it meets none.
std::optional<double> heightOnAxis(const surface::TriangleMesh& skin, const Eigen::Matrix3d& axes,
                                   const Eigen::Vector3d& pivot_mm);

/// Mean outward normal of the skin round the axis, weighted by a Gaussian; nothing where there is no skin.
std::optional<Eigen::Vector3d> normalRound(const surface::TriangleMesh& skin, const Eigen::Matrix3d& axes,
                                           const Eigen::Vector3d& pivot_mm, double height_mm,
                                           double sigma_mm);

/// Slopes of the plane over all places that is lowest at the axis: that of a plate pressed along it. Nothing
/// where the places do not surround the axis.
std::optional<Eigen::Vector2d> pressedSlope(const std::vector<OverPlate>& places);
/// Height at the axis of the plane with these slopes that rests on the places.
double heightOfPlate(const std::vector<OverPlate>& places, const Eigen::Vector2d& slope);

}  // namespace facenav::guidance
