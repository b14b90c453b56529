#pragma once
// The affine part of the registration: Gauss-Newton on both channels.

#include "brain_pair.h"

namespace facenav::atlas {

/// Start value from the brains' moments: aligns the centres and the extents along R, A, S; no rotation.
Eigen::Affine3d affineFromMoments(const BrainPair& pair);
/// Best `mri_from_mni` near `start`. Deterministic; at most `iterations` steps, fewer if a step changes
/// nothing.
Eigen::Affine3d fitAffine(const BrainPair& pair, const Eigen::Affine3d& start, int iterations);
/// Mean squared difference of both channels over both brains; the fits minimise it.
double cost(const BrainPair& pair, const Channels& moving);

}  // namespace facenav::atlas
