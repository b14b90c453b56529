#pragma once
// Uncertainty of the skin at each place of the scalp: small where tissue ends in dark air within a voxel or
// two, large beneath pads and haze, and where the edge is blurred.

#include "facenav/volume/volume.h"
#include "scalp_outline.h"

namespace facenav::surface {

/// Standard error along the normal, mm, per vertex of a mesh that lies on the skin of `head`. Air is the
/// darker of two levels, near the skin and far from the head, so that haze on all sides is no air.
std::vector<float> skinDoubt_mm(const TriangleMesh& mesh, const MeshNeighbours& neighbours,
                                const volume::Volume& scan, const volume::Mask& head);

}  // namespace facenav::surface
