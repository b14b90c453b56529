#include "scan_sharpness.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "facenav/core/robust_statistics.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/segmentation/brain_growth.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/smoothing.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

constexpr double kSpread = 0.26;  // variance of MR's point spread (FWHM 1.21 voxels), per voxel edge squared
constexpr double kCoarsest_mm = 1.5;  // coarsest voxel whose point spread can be sharpened
constexpr double kBrightest = 1.15;   // relative to white matter: vessels are brighter
constexpr double kDeep_mm = 3.2;      // deeper in white matter there is only noise
constexpr double kPass_mm2 = 0.5;     // variance added by one pass of `smoothed` on a grid of 1 mm
constexpr double kMostVariance = 0.5;

float laplacian(const float* at, std::size_t row, std::size_t slab) {
  return at[-1] + at[1] + at[row] + *(at - row) + at[slab] + *(at - slab) - 6 * *at;
}

/// Mean square of the Laplacian over `core` minus that of the noise (scaled median over `deep`).
double edgeEnergy(const Volume& image, const Mask& core, const Mask& deep) {
  const std::size_t row = image.grid.size[0], slab = row * image.grid.size[1];
  double sum = 0, count = 0;
  std::vector<float> noise;
  for (std::size_t v = slab; v + slab < image.voxels.size(); ++v) {
    if (!core.voxels[v]) continue;
    const float value = laplacian(&image.voxels[v], row, slab);
    sum += double(value) * value, ++count;
    if (deep.voxels[v]) noise.push_back(std::abs(value));
  }
  if (count == 0) return 0;
  if (noise.empty()) return sum / count;
  return sum / count - std::pow(kSigmaPerMad * upperMedian(std::move(noise)), 2);
}

Mask deepWhiteMatter(const Volume& image, const Mask& core, const TissueModel& tissue) {
  const Volume calm = volume::smoothed(volume::smoothed(image));
  Mask white = core;
  const float low = float(0.5 * (tissue.grey.mean + tissue.white.mean));
  for (std::size_t v = 0; v < white.voxels.size(); ++v) white.voxels[v] &= calm.voxels[v] > low;
  return erode(white, kDeep_mm);
}

}  // namespace

double pointSpread_mm2(const Volume& image, const Mask& core, const TissueModel& tissue) {
  Volume once = image;
  const float most = float(kBrightest * tissue.white.mean);
  for (float& value : once.voxels) value = std::clamp(value, 0.f, most);
  const Mask deep = deepWhiteMatter(once, core, tissue);
  once = volume::smoothed(std::move(once));  // one pass against noise
  const double fine = edgeEnergy(once, core, deep);
  const double coarse = edgeEnergy(volume::smoothed(once), core, deep);
  if (!(coarse > 0) || !(fine > coarse)) return 0;
  // fine / coarse = ((own + 2 passes) / (own + 1 pass))^(3/2)
  return std::max(0.0, kPass_mm2 / (std::pow(fine / coarse, 2.0 / 3) - 1) - kPass_mm2);
}

Volume atCommonSharpness(const Volume& image, const volume::VoxelGrid& scan, const Mask& core,
                         const TissueModel& tissue) {
  const double own = pointSpread_mm2(image, core, tissue);
  const double common_mm2 = settingsOf<BrainGrowth>().common_spread_mm2;
  if (own <= 0) return image;
  Eigen::Vector3d edge2_mm2;
  for (int a = 0; a < 3; ++a)
    edge2_mm2[a] = std::pow(std::clamp(scan.mri_from_voxel.linear().row(a).norm(), 1.0, kCoarsest_mm), 2);
  Eigen::Vector3d more;
  for (int a = 0; a < 3; ++a)
    more[a] = std::clamp(common_mm2 - own - kSpread * (edge2_mm2[a] - edge2_mm2.mean()), -kMostVariance,
                         kMostVariance);
  return volume::spread(image, more);
}

double noiseOf(const Volume& flat, const Volume& calm, const Mask& core, const TissueModel& tissue) {
  constexpr double kWithNeighbours = 7.0 / 6;  // variance of the difference over that of one voxel
  const float low = float(0.5 * (tissue.grey.mean + tissue.white.mean));
  const std::size_t row = flat.grid.size[0], slab = row * flat.grid.size[1];
  std::vector<float> differences;
  for (std::size_t v = slab; v + slab < core.voxels.size(); ++v) {
    if (!core.voxels[v] || calm.voxels[v] <= low) continue;
    const float* at = &flat.voxels[v];
    const float around = (at[-1] + at[1] + at[row] + *(at - row) + at[slab] + *(at - slab)) / 6;
    differences.push_back(std::abs(*at - around));
  }
  if (differences.empty()) return 0;
  return kSigmaPerMad * upperMedian(std::move(differences)) / std::sqrt(kWithNeighbours);
}

Volume calmed(const Volume& flat, double noise, double contrast) {
  const double wanted = settingsOf<BrainGrowth>().calm_noise * contrast /
                        std::max(noise, 1e-9);  // share of the noise that may remain
  if (wanted >= 1) return flat;
  // The kernel (v/2, 1 - v, v/2) leaves (1 - v)^2 + v^2 / 2 of the variance along each axis.
  const double along = std::pow(wanted, 2.0 / 3);
  const double root = std::max(0.0, 1 - 1.5 * (1 - along));
  const double variance = std::min(kMostVariance, (1 - std::sqrt(root)) / 1.5);
  return volume::spread(flat, Eigen::Vector3d::Constant(variance));
}

}  // namespace facenav::segmentation
