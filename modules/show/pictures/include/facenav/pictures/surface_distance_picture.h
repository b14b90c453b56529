#pragma once
// Draws the cortex with open sulci from six sides, coloured by its distance to the phi-theta surface, with
// the legend and the figures in both directions. It shows where the phi-theta model can be trusted. Computed
// without a display. Stored in the case as surface_distance.png.

#include <array>
#include <functional>

#include "facenav/core/rgb_image.h"
#include "facenav/surface/detailed_cortex.h"

namespace facenav::pictures {

/// Colour (red, green, blue in 0..1) of a signed distance in mm (> 0: outside the phi-theta surface).
using DistanceColour = std::function<std::array<double, 3>(double)>;

/// Draws left, right and top above front, back and bottom, 2 pixels per mm, along Mri's axes. The legend runs
/// from -`full_mm` to `full_mm`. Returns an image without pixels for an empty cortex.
RgbImage drawSurfaceDistance(const surface::DetailedCortex& cortex, const surface::ModelDistance& figures,
                             double full_mm, const DistanceColour& colour);

}  // namespace facenav::pictures
