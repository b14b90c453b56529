#pragma once
// Smooth and fill holes, on the whole mask or within a ball.

#include <optional>

#include "facenav/editing/mask_change.h"

namespace facenav::editing {

struct Ball {
  Point<Mri> centre;
  double radius_mm;
};

/// Each voxel takes the majority value of its surroundings: the mask is averaged with a Gaussian of about
/// `sigma_mm` and cut at one half. Removes spikes and fills notches; flat faces do not move.
MaskChange smooth(const volume::Mask& mask, double sigma_mm,
                  const std::optional<Ball>& within = std::nullopt);
/// Background that no 6-connected path joins to the outside of the mask becomes mask.
MaskChange fillHoles(const volume::Mask& mask);

}  // namespace facenav::editing
