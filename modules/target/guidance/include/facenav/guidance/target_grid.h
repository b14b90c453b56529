#pragma once
// A grid of points round a target, on the scalp or on the brain's hull. From the seed, tapes are laid
// straight ahead and back along the handle, one point per row; from each of these to the left and right, one
// point per column. The handle's direction is carried along each tape (parallel transport), so that it
// follows the curvature. Spacing is exact along each tape. Away from the middle column, columns come closer
// to each other, as on any curved body: by (distance from it / radius of the head)^2 / 2, 2 % at 15 mm.

#include <vector>

#include "facenav/guidance/target.h"
#include "facenav/surface/scalp_path.h"

namespace facenav::guidance {

struct GridPoint {
  int row = 1, column = 1;  // row 1 is the foremost, column 1 the leftmost seen from above the coil
  Eigen::Vector3d place_mm = Eigen::Vector3d::Zero();   // on the surface, Mri
  Eigen::Vector3d outwards = Eigen::Vector3d::UnitZ();  // the surface's normal there
  Eigen::Vector3d forward = Eigen::Vector3d::UnitY();   // the coil's y there, along the surface
};

/// Throws Error for a grid of fewer than 2 points or more than 15 x 15, or a spacing outside 1..30 mm.
void requireSensible(const GridSpec& grid);

/// Returns rows x columns points, row by row. `mesh`: the surface of `surface`; `seed_mm`: the seed's
/// position on it; `axes`: the seed's coil axes. Throws Error where the surface ends.
std::vector<GridPoint> gridRound(const surface::ScalpPaths& paths, const surface::TriangleMesh& mesh,
                                 const Eigen::Vector3d& seed_mm, const Eigen::Matrix3d& axes,
                                 const GridSpec& grid);

}  // namespace facenav::guidance
