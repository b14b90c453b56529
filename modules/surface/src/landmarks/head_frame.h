#pragma once
// The head's own axes, found on the skin: x along the normal of the plane of symmetry (to the patient's
// right), y to the front along the line opisthocranion-glabella, z up. Landmark windows and widths are given
// in it, so that a head that lies turned or nodding in the scanner measures the same.

#include <Eigen/Geometry>

#include "facenav/surface/scalp_surface.h"

namespace facenav::surface {

/// head_from_mri with y along Mri's y as far as the plane of symmetry allows: iterated reflection of the skin
/// onto itself, point to plane, with weights that forgive ears and cuts. Heads turned by up to 25 degrees.
Eigen::Isometry3d symmetryFrame(const TriangleMesh& scalp);

/// `frame` turned about its x axis, about its origin, so that the direction `forward_head` becomes +y.
Eigen::Isometry3d pitched(const Eigen::Isometry3d& frame, const Eigen::Vector3d& forward_head);

}  // namespace facenav::surface
