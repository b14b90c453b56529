#pragma once
// Tissue share of each voxel, from a scan and its brain mask (sulci closed). The 0.5 level of this field is
// the cortex with open sulci. Works on any mask, drawn or segmented, so that an edited case can be modelled
// again.

#include "facenav/core/task_monitor.h"
#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// Computes the share on a RAS grid of cubic voxels (`spacing_mm`) around the brain: 0 in fluid and outside
/// the mask, 1 in tissue. Between them linear in the bias-corrected intensity, from the mean of fluid to that
/// of grey matter. Fluid enclosed by tissue (ventricles) counts as tissue, so that the field has inner
/// surfaces only where ventricles open to the outside. Throws Error for an empty mask, and if grey and white
/// matter do not differ.
volume::Volume tissueShare(const volume::Volume& mri, const volume::Mask& brain, double spacing_mm,
                           TaskMonitor& monitor);

}  // namespace facenav::segmentation
