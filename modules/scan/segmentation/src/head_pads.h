#pragma once
// Pads, earphones and other things that touch the head in a scan and are brighter than air. The brain prior's
// network was trained with such things as air; a region that it classifies as air although it is as bright as
// tissue, and that extends far from the head, is one.

#include <optional>

#include "facenav/segmentation/head_outline.h"
#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// Probability of air by the brain prior's network on `grid`. Beside and above the network's window: the
/// value at the window's end; below it: 0. nullopt if no brain is found or the weights are missing.
std::optional<volume::Volume> airByPrior(const volume::Volume& scan, const volume::VoxelGrid& grid);

/// Finds the pads within `solid` (head and all that touches it), on the grid of `air`.
volume::Mask findPads(const volume::Mask& solid, const volume::Volume& air, const HeadOutline& outline);

}  // namespace facenav::segmentation
