#pragma once
// The phi-theta array (paper, equations 6-8): surface and colour in the direction of each bin.

#include "facenav/surface/brain_model.h"

namespace facenav::surface {

SphericalMap mapBrain(const volume::Volume& volume, const volume::Mask& brain,
                      const BrainModelOptions& options, TaskMonitor& monitor);

}  // namespace facenav::surface
