#include "prior/leaks_and_gaps.h"

#include <algorithm>

#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/regrid.h"

namespace facenav::segmentation {
namespace {

/// Voxels of `mask` that lie far from `other`, on one grid.
std::size_t countFar(const volume::Mask& mask, const volume::Mask& other, double far_mm) {
  const std::vector<float> away_mm = volume::distanceTo(other);
  std::size_t count = 0;
  for (std::size_t v = 0; v < away_mm.size(); ++v) count += mask.voxels[v] && away_mm[v] > float(far_mm);
  return count;
}

}  // namespace

double leaksAndGaps(const volume::Mask& grown, const volume::Mask& prior, double far_mm) {
  const volume::Mask other = volume::resample(grown, prior.grid);
  const auto whole = std::count(prior.voxels.begin(), prior.voxels.end(), std::uint8_t{1});
  if (whole == 0) return 1;
  return double(countFar(other, prior, far_mm) + countFar(prior, other, far_mm)) / double(whole);
}

}  // namespace facenav::segmentation
