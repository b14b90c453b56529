#include "insideness.h"

#include <utility>

#include "facenav/volume/regrid.h"
#include "facenav/volume/smoothing.h"

namespace facenav::surface {

using volume::Mask;
using volume::Volume;

Volume insideness(const Mask& mask, double spacing_mm) {
  const double margin_mm = mask.grid.spacing_mm().maxCoeff() + 3 * spacing_mm;
  return volume::smoothed(volume::shareOn(mask, volume::gridAround(mask, spacing_mm, margin_mm)));
}

}  // namespace facenav::surface
