#pragma once
// Morphology of the head mask that other masks do not need (volume/mask_morphology.h has the rest): finds the
// air that is outside.

#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// Grows `seed` inside `limit` by at most `steps` voxels.
volume::Mask growInside(const volume::Mask& seed, const volume::Mask& limit, int steps);
/// Fills everything that the outside cannot reach. On each face of the grid, a region enclosed within that
/// face counts as inside, so that an airway through the scan's lower end does not connect to the outside.
volume::Mask fillCavities(const volume::Mask& mask);
/// Adds voxels from which at most `most_open` of the 26 grid directions reach the outside: sinuses, nostrils,
/// ear canals, and the dark bone under a scalp whose face was cut off.
volume::Mask fillOccluded(const volume::Mask& mask, int most_open);
/// Returns tissue plus the cavities within it. Filled creases of the outer surface (between ear and head,
/// beside the nose) are removed again.
volume::Mask withoutCavities(const volume::Mask& tissue);

}  // namespace facenav::segmentation
