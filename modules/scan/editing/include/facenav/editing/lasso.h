#pragma once
// Lasso: all voxels of the displayed slice within a closed outline drawn on it.

#include "facenav/editing/brush.h"
#include "facenav/volume/slice_plane.h"

namespace facenav::editing {

/// A closed outline; the even-odd rule applies where it crosses itself. Pixels (u, v) of a slice, or screen
/// coordinates.
using Outline = std::vector<Eigen::Vector2d>;

/// True if `p` is inside by the even-odd rule.
bool isInside(const Outline& outline, const Eigen::Vector2d& p);
/// The voxels whose centres are in the slice (one voxel thick) and within the outline.
MaskChange lasso(const volume::Mask& mask, const volume::SlicePlane& plane, const Outline& outline,
                 bool is_brain);

}  // namespace facenav::editing
