#pragma once
// The working volume of a scan and the brain prior's result for it. Head and brain are segmented at the same
// time and share it, so it is computed once.

#include <memory>

#include "prior/brain_prior.h"

namespace facenav::segmentation {

struct ScanPrior {
  volume::Volume working;  // RAS, voxels of 1 mm, air about 0
  std::optional<BrainPrior> prior;
};

/// Returns the result of the same scan (by grid and voxels) while someone keeps it, else computes it. A
/// second thread that asks meanwhile waits for the first.
std::shared_ptr<const ScanPrior> scanPrior(const PriorNetwork& network, const volume::Volume& scan);

}  // namespace facenav::segmentation
