#pragma once
// The brain's surface: iso-surface of the mask, with both banks of every sulcus that is open in the mask,
// smoothed by a windowed sinc that keeps the volume. For planning and measuring; the phi-theta BrainModel is
// the paper's picture of it.

#include "facenav/core/task_monitor.h"
#include "facenav/surface/triangle_mesh.h"
#include "facenav/volume/volume.h"

namespace facenav::surface {

struct CortexOptions {
  double spacing_mm = 1.0;   // of the grid for the iso-surface
  int smoothing_steps = 15;  // steps of the windowed sinc; 0: no smoothing
};

/// Extracts a closed mesh with outward normals. Throws Error for an empty mask.
TriangleMesh extractCortex(const volume::Mask& brain, const CortexOptions& options, TaskMonitor& monitor);

}  // namespace facenav::surface
