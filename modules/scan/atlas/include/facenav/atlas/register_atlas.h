#pragma once
// registerAtlas: part of PREPARE, after the brain mask. An affine fit (12 degrees of freedom, Gauss-Newton),
// then diffeomorphic demons (Vercauteren et al. 2009: compositive updates, efficient second-order forces).
// Two channels: the T1 normalised by its local mean and deviation inside the brain, which removes bias fields
// and contrast differences; and the brain mask itself.

#include "facenav/atlas/atlas_map.h"
#include "facenav/atlas/brain_template.h"
#include "facenav/core/field.h"
#include "facenav/core/task_monitor.h"

namespace facenav::atlas {

struct AtlasOptions {
  double spacing_mm = 2.0;     // at the finest level
  int iterations_coarse = 40;  // at twice that spacing
  int iterations_fine = 25;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(Field{"spacing_mm", "grid of the warp", 1, 4}, self.spacing_mm);
    visitor(Field{"iterations_coarse", "steps of the warp at 8 mm and at twice that spacing", 0, 500},
            self.iterations_coarse);
    visitor(Field{"iterations_fine", "steps of the warp at the finest grid", 0, 500}, self.iterations_fine);
  }
};

/// Quality of a registration. It is shown to the user, and labels are refused if the fit is poor.
struct AtlasQuality {
  double correlation_affine = 0, correlation = 0;  // locally normalised T1 inside the brain, -1..1
  double dice = 0;                                 // overlap of both brains after the warp
  double smallest_jacobian = 0;                    // > 0: invertible everywhere on the grid
  bool isUsable() const { return dice > 0.9 && correlation > 0.3 && smallest_jacobian > 0; }
};

struct AtlasFit {
  AtlasMap map;
  AtlasQuality quality;
};

/// Registers the template to a patient. `mri`: T1-weighted, any orientation; `brain`: its brain mask, any
/// grid. Throws Error for an empty mask, Cancelled.
AtlasFit registerAtlas(const volume::Volume& mri, const volume::Mask& brain, const BrainTemplate& atlas,
                       const AtlasOptions& options, TaskMonitor& monitor);

}  // namespace facenav::atlas
