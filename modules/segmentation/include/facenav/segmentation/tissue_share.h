#pragma once
// From a scan and its brain mask (sulci closed) to how much of each place is tissue: the field whose 0.5
// level is the cortex with open sulci. Works on any mask, drawn by hand or found, so that an edited case can
// be modelled anew.

#include "facenav/core/task_monitor.h"
#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// On a RAS grid of cubic voxels (`spacing_mm`) around the brain: 0 in fluid and outside the mask, 1 in
/// tissue, between them by intensity (fluid's to grey matter's mean, bias field taken off). Fluid that tissue
/// encloses (ventricles) counts as tissue: the field has no inner surfaces but where these open to the
/// outside. Throws Error for an empty mask and where grey and white matter do not differ.
volume::Volume tissueShare(const volume::Volume& mri, const volume::Mask& brain, double spacing_mm,
                           TaskMonitor& monitor);

}  // namespace facenav::segmentation
