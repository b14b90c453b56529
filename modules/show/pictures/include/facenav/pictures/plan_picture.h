#pragma once
// The plan on the head: scalp with landmarks, EEG sites, and each target's coil as its plate's outline with
// the handle's direction. Drawn without a screen.

#include <string>
#include <vector>

#include "facenav/core/rgb_image.h"
#include "facenav/guidance/coil_plate.h"
#include "facenav/surface/named_place.h"
#include "facenav/surface/scalp_surface.h"

namespace facenav::pictures {

using surface::NamedPlace;

/// From the left, the front, above, the right and behind, side by side; 2 pixels per mm, along the axes of
/// Mri. A place is drawn where no skin hides it. `landmarks` are orange, `sites` green, targets blue. Of a
/// grid, the seed is drawn whole and its other targets as dots, so that the picture stays readable; the
/// target called `active` is drawn whole in any case, and is the only one named where one is given.
RgbImage drawPlan(const surface::ScalpSurface& scalp, const std::vector<NamedPlace>& landmarks,
                  const std::vector<NamedPlace>& sites, const std::vector<guidance::Target>& targets,
                  const guidance::CoilPlate& plate, const std::string& active = {});

}  // namespace facenav::pictures
