#pragma once
// Where a grown brain and the prior's outline really differ. Growth closes wide fissures that the prior
// leaves open, and its outline may lie a little further out everywhere. Neither is a leak, but both lower the
// Dice.

#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// What either mask has further than `far_mm` from the other, as a share of the volume of `prior`; 1 where
/// `prior` is empty. Judged on the grid of `prior`.
double leaksAndGaps(const volume::Mask& grown, const volume::Mask& prior, double far_mm);

}  // namespace facenav::segmentation
