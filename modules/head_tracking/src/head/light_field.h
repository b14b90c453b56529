#pragma once
// The light on the face now against that of the key frame: each patch's mean brightness over its own then,
// and how that ratio changes across the patch, from a plane through its neighbours' ratios. A lamp that
// moves, a head that turns under it, a highlight that wanders: all change slowly over the skin, and a ratio
// of means shows it to a few parts in a thousand. Needs no normals and no knowledge of the lamps.

#include "patch_model.h"
#include "pose_fit.h"

namespace facenav::head_tracking {

/// Relative slope of the light per pixel of the left key image, (right, down), at one patch in one camera;
/// zero where too few neighbours are seen.
Eigen::Vector2f lightSlope(const std::vector<Neighbour>& neighbours, const PatchSights& sights,
                           std::size_t patch, int camera);

}  // namespace facenav::head_tracking
