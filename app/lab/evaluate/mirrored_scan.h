#pragma once
// A scan whose left and right are exchanged, as a wrong transform in a file's header makes it.

#include "facenav/surface/scalp_surface.h"

namespace facenav::app {

/// Exchanges left and right of a scan's skin.
surface::ScalpSurface mirrored(surface::ScalpSurface scalp);

}  // namespace facenav::app
