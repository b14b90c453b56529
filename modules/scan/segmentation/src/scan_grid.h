#pragma once
// Masks from a part of the working grid to the scan's own grid and back.

#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// The part of the mask's grid that holds the mask, with a margin that may lie beyond it.
volume::VoxelGrid partAround(const volume::Mask& mask, double margin_mm);
/// By the level of the smoothed mask: the steps of the working grid, which lies anyhow against the scan's,
/// would leave their pattern in the scan's own.
volume::Mask onScanGrid(const volume::Mask& brain, const volume::VoxelGrid& scan);
/// Ball of the mask's volume about its centre of gravity, Mri: radius and place.
struct Ball {
  Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();
  double radius_mm = 0;
};
Ball ballLike(const volume::Mask& mask);

}  // namespace facenav::segmentation
