#pragma once
// Smooth and fill holes: of the whole mask, or within a ball about a place.

#include <optional>

#include "facenav/editing/mask_change.h"

namespace facenav::editing {

struct Ball {
  Point<Mri> centre;
  double radius_mm;
};

/// A voxel becomes what most of its surroundings are: the mask averaged with a Gaussian of about `sigma_mm`,
/// cut at one half. Shaves off spikes, fills notches, holds flat faces still.
MaskChange smooth(const volume::Mask& mask, double sigma_mm,
                  const std::optional<Ball>& within = std::nullopt);
/// Background that no 6-connected path joins to the mask's outside becomes mask.
MaskChange fillHoles(const volume::Mask& mask);

}  // namespace facenav::editing
