#pragma once
// The directions that define a handle angle: reference and medial, unit vectors in the plane tangent to the
// scalp. Mri frame.

#include "facenav/guidance/handle.h"
#include "facenav/surface/triangle_mesh.h"

namespace facenav::guidance {

struct TangentDirections {
  Eigen::Vector3d forward, medial;  // angle 0, and +90 degrees
  HandleReference reference = HandleReference::anterior;
};

/// Directions for a coil whose axis `z` (unit) points into the head at `cortex_point`.
TangentDirections tangentDirections(const surface::TriangleMesh& scalp, const Eigen::Vector3d& z,
                                    const Point<Mri>& cortex_point);

}  // namespace facenav::guidance
