#pragma once
// Draws planned targets and coils into a copy of an MRI's voxels, for programs that show images alone: a
// cross round the cortex point, the outline of the coil's plate with its handle, the coil's axis (dashed),
// the target's name beside the cross, and on every slice that it is not for diagnosis. Marks are white with
// a black edge. Words are drawn as the slices (i to the right, j downwards) are seen.

#include <string>
#include <vector>

#include "facenav/guidance/coil_plate.h"
#include "facenav/guidance/target.h"
#include "facenav/volume/volume.h"

namespace facenav::pictures {

struct BurntPlan {
  volume::Volume volume;
  float black = 0, white = 1;  // values of the marks, and the window in which they and the tissue are seen
};

/// Draws the targets, each with a coil of this plate at its planned pose. Throws Error for a target whose
/// cortex point lies outside the MRI.
BurntPlan burnPlan(const volume::Volume& mri, const std::vector<guidance::Target>& targets,
                   const guidance::CoilPlate& plate);

/// A mark as the voxels that it covers.
struct PlanMask {
  std::string label;
  volume::Mask mask;  // on the MRI's grid
  bool is_coil = false;
};

/// Makes for each target a ball of 5 mm round its cortex point, and the outline, handle and axis of its coil.
std::vector<PlanMask> planMasks(const volume::VoxelGrid& grid, const std::vector<guidance::Target>& targets,
                                const guidance::CoilPlate& plate);

}  // namespace facenav::pictures
