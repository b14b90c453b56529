#pragma once
// Width of the edge between air and skin in the scan. A defacing tool that blurs the face widens it there,
// while the rest of the head keeps the scanner's sharpness.

#include <vector>

#include "facenav/surface/triangle_mesh.h"
#include "facenav/volume/volume.h"

namespace facenav::surface {

/// Per vertex of the skin (Mri): height of the step from air to tissue over its steepest slope, mm.
std::vector<float> edgeWidth_mm(const TriangleMesh& mesh, const volume::Volume& scan);

}  // namespace facenav::surface
