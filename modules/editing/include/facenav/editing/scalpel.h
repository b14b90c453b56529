#pragma once
// Scalpel: a lasso drawn on the 3-D view, pushed through the mask along the view's rays. What lies behind the
// outline is cut away, all of it or down to a depth below what is seen.

#include <Eigen/Core>

#include "facenav/editing/lasso.h"

namespace facenav::editing {

struct ScalpelView {
  /// Homogeneous: (x, y, z, w) = M (Mri mm, 1); screen = (x / w, y / w), in the outline's units; w > 0 in
  /// front of the camera. VTK: the viewport's scaling times the camera's composite projection matrix.
  Eigen::Matrix4d screen_from_mri;
  Point<Mri> eye;  // of the camera; far away for parallel projection: depth is measured from it
};

/// `depth_mm` > 0: only what lies no deeper than this behind the first voxel that its ray meets; 0: through
/// and through.
MaskChange cut(const volume::Mask& mask, const ScalpelView& view, const Outline& outline,
               double depth_mm = 0);

}  // namespace facenav::editing
