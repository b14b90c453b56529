#pragma once
// The skin under a plate: heights over the plate's plane, and the plane that rests on them.

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "facenav/guidance/coil_plate.h"
#include "facenav/surface/triangle_mesh.h"

namespace facenav::guidance {

/// A point relative to the plate's plane: x and y in it (mm), height along the coil's -z.
using OverPlate = Eigen::Vector3d;

/// Radius of the circle about the coil's centre that contains the outline.
double radius_mm(const CoilPlate& plate);
bool isInside(const std::vector<Eigen::Vector2d>& outline, const Eigen::Vector2d& p);

/// Returns the triangles with a corner within `radius_mm` of `centre_mm`; without normals.
surface::TriangleMesh partWithin(const surface::TriangleMesh& mesh, const Eigen::Vector3d& centre_mm,
                                 double radius_mm);

/// Returns the skin's vertices within the outline, in the axes of a coil at `pivot`. Vertices more than
/// `reach_mm` below the highest are left out, because they lie on the other side of the head.
std::vector<OverPlate> skinUnder(const surface::TriangleMesh& skin, const CoilPlate& plate,
                                 const Eigen::Matrix3d& axes, const Eigen::Vector3d& pivot_mm);

/// Height of the highest skin within the outline, triangles cut by it included; nothing without skin.
std::optional<double> highest(const surface::TriangleMesh& skin, const CoilPlate& plate,
                              const Eigen::Matrix3d& axes, const Eigen::Vector3d& pivot_mm);

/// Height of the outermost skin on the axis; nothing where the axis meets none.
std::optional<double> heightOnAxis(const surface::TriangleMesh& skin, const Eigen::Matrix3d& axes,
                                   const Eigen::Vector3d& pivot_mm);

/// Mean outward normal of the skin round the axis, weighted by a Gaussian; nothing where there is no skin.
std::optional<Eigen::Vector3d> normalRound(const surface::TriangleMesh& skin, const Eigen::Matrix3d& axes,
                                           const Eigen::Vector3d& pivot_mm, double height_mm,
                                           double sigma_mm);

/// Slopes of the plane, above all points, that is lowest at the axis: the plane of a plate pressed along the
/// axis. Nothing if the points do not surround the axis.
std::optional<Eigen::Vector2d> pressedSlope(const std::vector<OverPlate>& places);
/// Height at the axis of the plane with these slopes that rests on the points.
double heightOfPlate(const std::vector<OverPlate>& places, const Eigen::Vector2d& slope);

}  // namespace facenav::guidance
