#pragma once
// The warp part of the registration: diffeomorphic demons at one spacing.

#include <functional>

#include "brain_pair.h"
#include "facenav/core/task_monitor.h"

namespace facenav::atlas {

/// A zero displacement on a pair's grid, in nodes.
VectorField noDisplacement(const std::array<int, 3>& size);
/// Resamples a displacement onto a finer or coarser grid over the same space (in nodes of the new grid).
VectorField onGrid(const VectorField& displacement, const volume::VoxelGrid& from,
                   const volume::VoxelGrid& to);
/// Improves `displacement` (nodes) by compositive updates of at most half a node each. Updates are smoothed
/// before they are applied, and the sum is smoothed afterwards, so that it stays invertible.
VectorField runDemons(const BrainPair& pair, const Eigen::Affine3d& mri_from_mni, VectorField displacement,
                      int iterations, const std::function<void(double)>& on_progress);
/// Smallest determinant of the Jacobian of x + d(x) over the grid.
double smallestJacobian(const VectorField& displacement);

}  // namespace facenav::atlas
