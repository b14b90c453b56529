#pragma once
// The affine part: Gauss-Newton on both channels.

#include "brain_pair.h"

namespace facenav::atlas {

/// From the brains' moments: centres coincide, extents along R, A, S agree, no rotation.
Eigen::Affine3d affineFromMoments(const BrainPair& pair);
/// Best `mri_from_mni` near `start`. Deterministic; at most `iterations` steps, fewer once a step moves
/// nothing.
Eigen::Affine3d fitAffine(const BrainPair& pair, const Eigen::Affine3d& start, int iterations);
/// Mean squared difference of both channels over both brains: what the fits minimise.
double cost(const BrainPair& pair, const Channels& moving);

}  // namespace facenav::atlas
