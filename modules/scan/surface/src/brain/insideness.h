#pragma once
// A mask as a smooth field: 1 inside, 0 outside, a slope between. Its level 0.5 is a surface with sub-voxel
// accuracy.

#include "facenav/volume/volume.h"

namespace facenav::surface {

/// Smooth field of `mask` on an axis-aligned grid with cubic voxels around it and a margin of zeros. Throws
/// Error for an empty mask.
volume::Volume insideness(const volume::Mask& mask, double spacing_mm);

}  // namespace facenav::surface
