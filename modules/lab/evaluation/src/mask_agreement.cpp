#include "facenav/evaluation/mask_agreement.h"

#include <numeric>

#include "facenav/core/error.h"
#include "facenav/evaluation/error_statistics.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/regrid.h"

namespace facenav::evaluation {
namespace {

using volume::Mask;

/// Adds a rim of background, so that the ball of a closing fits beyond the brain.
Mask padded(const Mask& mask, int rim) {
  Mask out;
  out.grid = mask.grid;
  for (int a = 0; a < 3; ++a) out.grid.size[a] += 2 * rim;
  out.grid.mri_from_voxel.translate(Eigen::Vector3d::Constant(-rim));
  out.voxels.assign(out.grid.count(), 0);
  for (int k = 0; k < mask.grid.size[2]; ++k)
    for (int j = 0; j < mask.grid.size[1]; ++j)
      std::copy_n(&mask.voxels[mask.grid.index(0, j, k)], mask.grid.size[0],
                  &out.voxels[out.grid.index(rim, j + rim, k + rim)]);
  return out;
}

Mask cropped(const Mask& mask, const volume::VoxelGrid& grid, int rim) {
  Mask out{grid, std::vector<std::uint8_t>(grid.count())};
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      std::copy_n(&mask.voxels[mask.grid.index(rim, j + rim, k + rim)], grid.size[0],
                  &out.voxels[grid.index(0, j, k)]);
  return out;
}

/// Distances from the surface voxels of `from` to the nearest ones of `to`, mm.
std::vector<double> distances_mm(const Mask& from, const Mask& to) {
  const auto nearest = volume::distanceTo(to);
  std::vector<double> distances;
  for (std::size_t v = 0; v < nearest.size(); ++v)
    if (from.voxels[v]) distances.push_back(nearest[v]);
  return distances;
}

}  // namespace

MaskAgreement compareMasks(const Mask& found_anywhere, const Mask& truth) {
  const Mask found =
      found_anywhere.grid.matches(truth.grid) ? found_anywhere : volume::resample(found_anywhere, truth.grid);
  const auto overlap = volume::overlap(found, truth);
  MaskAgreement agreement{overlap.dice, overlap.inside, 0, 0, found.volume_ml(), truth.volume_ml()};
  if (agreement.found_ml <= 0 || agreement.true_ml <= 0) throw Error("one of the masks to compare is empty");
  const Mask found_surface = volume::surfaceVoxels(found), true_surface = volume::surfaceVoxels(truth);
  auto all = distances_mm(found_surface, true_surface);
  const auto back = distances_mm(true_surface, found_surface);
  agreement.hausdorff95_mm = std::max(quantile(all, 0.95), quantile(back, 0.95));
  all.insert(all.end(), back.begin(), back.end());
  agreement.mean_distance_mm = std::accumulate(all.begin(), all.end(), 0.0) / double(all.size());
  return agreement;
}

Mask closedAndFilled(const Mask& tissue, double closing_voxels) {
  const int rim = int(std::ceil(closing_voxels)) + 1;
  const double radius_mm = closing_voxels * tissue.grid.spacing_mm().mean();
  return cropped(volume::fillHoles(volume::close(padded(tissue, rim), radius_mm)), tissue.grid, rim);
}

}  // namespace facenav::evaluation
