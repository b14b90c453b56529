#pragma once
// Distances between two surfaces: colour map and figures of the error of the phi-theta model.

#include "facenav/surface/closest_point.h"

namespace facenav::surface {

/// Distance in mm of every `step`-th vertex of `from` to the nearest place of `to`, > 0 outside it, < 0
/// inside. Throws Error if `to` has no triangles.
std::vector<float> signedDistances_mm(const TriangleMesh& from, const TriangleMesh& to, int step = 1);

struct SurfaceDistance {
  double median_mm = 0, p95_mm = 0, max_mm = 0;  // of absolute distances; all 0 for an empty list
};
SurfaceDistance summarise(const std::vector<float>& signed_distances_mm);

}  // namespace facenav::surface
