#pragma once
// Distance of a typed or clicked place outside the head. A place far outside is refused instead of being
// moved to the nearest cortex.

#include "facenav/surface/scalp_surface.h"

namespace facenav::surface {

/// A place farther outside the scalp is an error. Skin to cortex is 10 to 20 mm and the atlas has an error of
/// a few mm, so a typed place on the cortex never lies this far outside.
inline constexpr double kFarthestOutside_mm = 30.0;

/// Distance to the scalp in mm; 0 when the place is inside `head`. The mask decides, because the scalp is
/// open where the scan cuts it. Throws Error for a scalp without triangles.
double outsideHead_mm(const volume::Mask& head, const ScalpSurface& scalp, const Point<Mri>& p);

}  // namespace facenav::surface
