#pragma once
// The working volume of a scan and what the brain prior's network finds in it. Head and brain are segmented
// at the same time and both ask for it: it is made once.

#include <memory>

#include "prior/brain_prior.h"

namespace facenav::segmentation {

struct ScanPrior {
  volume::Volume working;  // RAS, voxels of 1 mm, air about 0
  std::optional<BrainPrior> prior;
};

/// Kept while someone holds it, and found again by the scan's grid and voxels. A second thread that asks
/// meanwhile waits for the first.
std::shared_ptr<const ScanPrior> scanPrior(const PriorNetwork& network, const volume::Volume& scan);

}  // namespace facenav::segmentation
