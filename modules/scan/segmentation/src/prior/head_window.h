#pragma once
// The network's window of a scan: voxels of 4 mm (means of the finer ones) about a place, black and white by
// percentiles of the window, as the network was trained (resources/training/brain_prior/synthesis.py,
// normalised()).

#include "facenav/geometry/point.h"
#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// Cuts out the window whose middle voxel contains `centre`. `coarse`: RAS grid of voxels of 4 mm; the window
/// takes its voxels unchanged. 0 beyond the scan.
volume::Volume headWindow(const volume::Volume& coarse, const Point<Mri>& centre);

}  // namespace facenav::segmentation
