#pragma once
// Maps masks from a part of the working grid to the scan's own grid and back.

#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// The part of the mask's grid that contains the mask, with a margin that may lie beyond it.
volume::VoxelGrid partAround(const volume::Mask& mask, double margin_mm);
/// Resamples by the level of the smoothed mask: the working grid is rotated against the scan's, and its steps
/// would leave a pattern.
volume::Mask onScanGrid(const volume::Mask& brain, const volume::VoxelGrid& scan);
/// Ball of the mask's volume about its centre of gravity: radius and place, Mri.
struct Ball {
  Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();
  double radius_mm = 0;
};
Ball ballLike(const volume::Mask& mask);

}  // namespace facenav::segmentation
