#pragma once
// Real differences of a grown brain from the prior's outline. Growth closes wide fissures that the prior
// leaves open, and its outline may lie a little further out everywhere. Neither is a leak, but both lower the
// Dice.

#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// Volume that either mask has further than `far_mm` from the other, as a share of the volume of `prior`; 1
/// if `prior` is empty. Computed on the grid of `prior`.
double leaksAndGaps(const volume::Mask& grown, const volume::Mask& prior, double far_mm);

}  // namespace facenav::segmentation
