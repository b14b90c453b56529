#pragma once
// What the head mask needs beyond the morphology of any mask (volume/mask_morphology.h): which air is
// outside.

#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// What grows out of `seed` inside `limit`, at most `steps` voxels far.
volume::Mask growInside(const volume::Mask& seed, const volume::Mask& limit, int steps);
/// Fills what the outside cannot reach. On each face of the grid what is enclosed in that face counts as
/// inside, so that an airway which leaves through the scan's lower end does not let the outside in.
volume::Mask fillCavities(const volume::Mask& mask);
/// Adds what sees the outside in at most `most_open` of the 26 grid directions: sinuses, nostrils, ear
/// canals, and the dark bone under a scalp whose face was cut off, however they open.
volume::Mask fillOccluded(const volume::Mask& mask, int most_open);

}  // namespace facenav::segmentation
