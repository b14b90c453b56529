#pragma once
// Builds both surfaces of the brain from a scan and the brain mask in force (automatic or edited): the
// paper's phi-theta model, and the detailed cortex with its distance to that model. Used by prepare and after
// an edit.

#include "facenav/surface/detailed_cortex.h"

namespace facenav::steps {

struct BrainSurfaces {
  surface::BrainModel model;
  surface::DetailedCortex cortex;
  surface::ModelDistance distance;
  bool has_open_sulci =
      true;  // false: no contrast of grey and white matter in the scan; the cortex is the mask's surface
};

/// Builds the surfaces. Throws Error if the mask is empty.
BrainSurfaces buildBrainSurfaces(const volume::Volume& mri, const volume::Mask& brain, TaskMonitor& monitor);

}  // namespace facenav::steps
