#pragma once
// The head's own axes, found on the skin: x along the normal of the plane of symmetry (to the patient's
// right), y to the front along the line opisthocranion-glabella, z up. Landmarks and widths are searched in
// it, so that a rotated or nodding head gives the same measures.

#include <Eigen/Geometry>

#include "facenav/surface/scalp_surface.h"

namespace facenav::surface {

/// head_from_mri with y as near to Mri's y as the plane of symmetry allows. Iterated reflection of the skin
/// onto itself, point to plane, robust to ears and cuts. For heads rotated by up to 25 degrees.
Eigen::Isometry3d symmetryFrame(const TriangleMesh& scalp);

/// Rotates `frame` about its own x axis so that the direction `forward_head` becomes +y.
Eigen::Isometry3d pitched(const Eigen::Isometry3d& frame, const Eigen::Vector3d& forward_head);

}  // namespace facenav::surface
