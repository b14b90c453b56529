#pragma once
// How far a place that was typed or clicked lies outside the head, so that one far away is refused instead of
// being taken for the nearest cortex.

#include "facenav/surface/scalp_surface.h"

namespace facenav::surface {

/// Farther outside the scalp a place is an error, not a place on the cortex. Skin to cortex is 10 to 20 mm
/// and the atlas errs by a few mm, so that a typed place of the cortex never lies this far outside.
inline constexpr double kFarthestOutside_mm = 30.0;

/// Distance to the scalp in mm; 0 where `head` holds the place. The mask decides, since the scalp is open
/// where the scan cuts it. Throws Error for a scalp without triangles.
double outsideHead_mm(const volume::Mask& head, const ScalpSurface& scalp, const Point<Mri>& p);

}  // namespace facenav::surface
