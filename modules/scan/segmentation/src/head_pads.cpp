#include "head_pads.h"

#include <cmath>

#include "facenav/volume/for_slices.h"
#include "facenav/volume/mask_morphology.h"
#include "head_morphology.h"
#include "prior/scan_prior.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

constexpr double kThinnest_mm = 2.5;  // half the thickness: ears are thinner
constexpr double kRegrow_mm = 24;
constexpr double kOuter_mm = 5;  // depth below the outer side
constexpr float kAir = 0.5f;
constexpr double kUnsure = 4;  // voxels at the window's end, where one of the two windows is missing

}  // namespace

std::optional<Volume> airByPrior(const Volume& scan, const volume::VoxelGrid& grid) {
  const InstalledPrior& installed = installedPrior();
  if (!installed.network) return std::nullopt;
  const auto found = scanPrior(*installed.network, scan);
  const auto& prior = found->prior;
  if (!prior) return std::nullopt;
  Volume air{grid, std::vector<float>(grid.count()), {}, {}};
  const Eigen::Affine3d window_from_voxel = prior->air.grid.mri_from_voxel.inverse() * grid.mri_from_voxel;
  const Eigen::Vector3d first = Eigen::Vector3d::Constant(kUnsure);
  Eigen::Vector3d last;
  for (int a = 0; a < 3; ++a) last[a] = prior->air.grid.size[std::size_t(a)] - 1 - kUnsure;
  volume::forSlices(grid.size[2], [&](int k) {
    std::size_t v = grid.index(0, 0, k);
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i, ++v) {
        const Eigen::Vector3d at = window_from_voxel * Eigen::Vector3d(i, j, k);
        if (at.z() < kUnsure) continue;
        air.voxels[v] = volume::sampleLinear(prior->air, at.cwiseMax(first).cwiseMin(last));
      }
  });
  return air;
}

Mask findPads(const Mask& solid, const Volume& air, const HeadOutline& outline) {
  Mask head = solid, beside = solid;
  for (std::size_t v = 0; v < solid.voxels.size(); ++v)
    head.voxels[v] = solid.voxels[v] && air.voxels[v] < kAir;
  head = fillCavities(volume::largestPart(head));
  const std::vector<float> away_mm = volume::distanceTo(head), depth_mm = volume::depthWithin(solid);
  Mask far = solid;
  for (std::size_t v = 0; v < far.voxels.size(); ++v) {
    beside.voxels[v] = solid.voxels[v] && !head.voxels[v];
    far.voxels[v] = beside.voxels[v] && away_mm[v] > float(outline.pad_away_mm);
  }
  far = volume::open(far, kThinnest_mm);
  Mask outer = far;  // sinuses that the scan's end opens have no outer side
  for (std::size_t v = 0; v < outer.voxels.size(); ++v)
    outer.voxels[v] = far.voxels[v] && depth_mm[v] < float(kOuter_mm);
  const int reach = int(kRegrow_mm / far.grid.spacing_mm().minCoeff());
  const double voxel_ml = far.grid.voxelVolume_mm3() * 1e-3;
  far = volume::withoutSpecks(volume::grow(outer, far, reach),
                              std::size_t(std::ceil(outline.pad_least_ml / voxel_ml)));
  return volume::grow(far, beside, reach);
}

}  // namespace facenav::segmentation
