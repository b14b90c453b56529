#pragma once
// Scalpel: a lasso drawn on the 3-D view, projected through the mask along the view's rays. It removes what
// lies behind the outline, completely or down to a depth below the visible surface.

#include <Eigen/Core>

#include "facenav/editing/lasso.h"

namespace facenav::editing {

struct ScalpelView {
  /// Homogeneous map: (x, y, z, w) = M (Mri mm, 1); screen = (x / w, y / w), in the outline's units; w > 0 in
  /// front of the camera. VTK: the viewport's scaling times the camera's composite projection matrix.
  Eigen::Matrix4d screen_from_mri;
  Point<Mri> eye;  // the camera's place: depth is measured from it; far away for parallel projection
};

/// Cuts behind the outline. `depth_mm` > 0: removes only voxels at most this far behind the first voxel on
/// their ray. 0: removes all.
MaskChange cut(const volume::Mask& mask, const ScalpelView& view, const Outline& outline,
               double depth_mm = 0);

}  // namespace facenav::editing
