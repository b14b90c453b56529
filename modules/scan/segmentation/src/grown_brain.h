#pragma once
// The brain grown downhill from white matter within a first mask (brain_refinement.h), in a T1: bias removed,
// common sharpness, noise reduced, tissue classes fitted. The first mask is BET's surface or the learned
// prior's outline.

#include <functional>
#include <optional>

#include "bet_surface.h"
#include "brain_tissue.h"
#include "facenav/core/task_monitor.h"
#include "facenav/segmentation/brain_growth.h"
#include "facenav/segmentation/segmenter.h"

namespace facenav::segmentation {

struct GrowthStart {
  volume::Volume working;  // after a rough removal of the bias
  BetSphere sphere;        // the brain's place and size
  TissueModel rough;
  volume::Mask first;    // on a part of the working grid
  double search_mm = 8;  // tissue is sought this far outside `first`
  double core_mm = 4;    // everything this deep in `first` is brain
};

/// Start from BET's surface, by the head's top and girth. `working`: see workingVolume. Throws Error "no
/// brain can be modelled: ...", Cancelled.
GrowthStart startFromHead(const volume::Volume& working, TaskMonitor& monitor);
/// Start from the learned prior's `outline`, on a part of the working grid.
GrowthStart startFromOutline(const volume::Volume& working, const volume::Mask& outline, double search_mm);

struct GrownBrain {
  volume::Mask mask;  // on a part of the working grid
  std::vector<BoundaryDoubt> doubts;
};
/// Grows the brain. `scan`: the grid of the scan, whose voxel size determines its sharpness. Returns nothing
/// if `isWanted` refuses the mask; the doubts, two thirds of the work, are not computed then. Throws Error
/// "no brain can be modelled: ..." if grey and white matter do not differ. Move `start` in: its working
/// volume is released before most memory is needed.
std::optional<GrownBrain> growBrain(GrowthStart start, const volume::VoxelGrid& scan, TaskMonitor& monitor,
                                    const std::function<bool(const volume::Mask&)>& isWanted);

}  // namespace facenav::segmentation
