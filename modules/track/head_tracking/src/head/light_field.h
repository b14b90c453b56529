#pragma once
// The light on the face relative to that of the key frame. Each patch gives the ratio of its mean brightness
// to that in the key frame; a plane through the neighbours' ratios gives the change of that ratio across the
// patch. Moving lamps, a turning head and moving highlights all change slowly over the skin, and the ratio
// shows them to a few parts in a thousand. Normals and positions of the lamps are not needed.

#include "patch_model.h"
#include "pose_fit.h"

namespace facenav::head_tracking {

/// Relative slope of the light per pixel of the left key image, (right, down), at one patch in one camera.
/// Zero if too few neighbours are visible.
Eigen::Vector2f lightSlope(const std::vector<Neighbour>& neighbours, const PatchMeasurements& measurements,
                           std::size_t patch, int camera);

}  // namespace facenav::head_tracking
