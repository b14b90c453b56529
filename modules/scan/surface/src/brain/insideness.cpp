#include "insideness.h"

#include <utility>

#include "facenav/volume/regrid.h"
#include "facenav/volume/smoothing.h"

namespace facenav::surface {

using volume::Mask;
using volume::Volume;

Volume insideness(const Mask& mask, double spacing_mm) {
  Volume inside;
  inside.grid = mask.grid;
  inside.voxels.assign(mask.voxels.begin(), mask.voxels.end());
  const double margin_mm = mask.grid.spacing_mm().maxCoeff() + 3 * spacing_mm;
  inside = volume::resample(inside, volume::gridAround(mask, spacing_mm, margin_mm));
  return volume::smoothed(std::move(inside));
}

}  // namespace facenav::surface
