#pragma once
// Draws the plan on the head: scalp with landmarks, EEG sites, and each target's coil as its plate's outline
// with the handle's direction. Needs no screen.

#include <string>
#include <vector>

#include "facenav/core/rgb_image.h"
#include "facenav/guidance/coil_plate.h"
#include "facenav/surface/named_place.h"
#include "facenav/surface/scalp_surface.h"

namespace facenav::pictures {

using surface::NamedPlace;

/// Draws the views from the left, front, top, right and back side by side; 2 pixels per mm, along the axes of
/// Mri. Points hidden by skin are left out. `landmarks` are orange, `sites` green, targets blue. A grid's
/// seed is drawn whole and its other targets as dots, so that the picture stays readable. The target called
/// `active` is always drawn whole; if it is given, only its name is drawn.
RgbImage drawPlan(const surface::ScalpSurface& scalp, const std::vector<NamedPlace>& landmarks,
                  const std::vector<NamedPlace>& sites, const std::vector<guidance::Target>& targets,
                  const guidance::CoilPlate& plate, const std::string& active = {});

}  // namespace facenav::pictures
