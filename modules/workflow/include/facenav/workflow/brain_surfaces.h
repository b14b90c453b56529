#pragma once
// From a scan and the brain mask in force (found or drawn) to both of the brain's surfaces: the paper's
// phi-theta model and the detailed cortex with its distance to that model. One call for prepare and after an
// edit.

#include "facenav/surface/detailed_cortex.h"

namespace facenav::workflow {

struct BrainSurfaces {
  surface::BrainModel model;
  surface::DetailedCortex cortex;
  surface::ModelDistance distance;
  bool has_open_sulci =
      true;  // false: the scan shows no grey and white matter, the cortex is the mask's surface
};

/// Throws Error where the mask is empty.
BrainSurfaces buildBrainSurfaces(const volume::Volume& mri, const volume::Mask& brain, TaskMonitor& monitor);

}  // namespace facenav::workflow
