#include "scan_sharpness.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "facenav/volume/smoothing.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

constexpr double kSpread = 0.26;  // variance of MR's point spread (FWHM 1.21 voxels), per voxel edge squared
constexpr double kCoarsest_mm = 1.5;  // whose point spread can be brought back
constexpr double kQuiet = 0.09;       // noise per contrast: single voxels lie 5 deviations from the limit
constexpr double kMostVariance = 0.5;

}  // namespace

Volume sharpAsOneMillimetre(const Volume& image, const volume::VoxelGrid& scan) {
  const Eigen::Matrix3d& steps = scan.mri_from_voxel.linear();
  Eigen::Vector3d variance;
  for (int a = 0; a < 3; ++a) {
    const double edge_mm = std::clamp(steps.row(a).norm(), 1.0, kCoarsest_mm);
    variance[a] = -kSpread * (edge_mm * edge_mm - 1);
  }
  return variance.isZero(1e-3) ? image : volume::spread(image, variance);
}

double noiseOf(const Volume& flat, const Volume& calm, const Mask& core, const TissueModel& tissue) {
  constexpr double kPerMedian = 1.4826,
                   kWithNeighbours = 7.0 / 6;  // of the normal law; variance of a difference
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
  const auto middle = differences.begin() + std::ptrdiff_t(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  return kPerMedian * *middle / std::sqrt(kWithNeighbours);
}

Volume calmed(const Volume& flat, double noise, double contrast) {
  const double wanted = kQuiet * contrast / std::max(noise, 1e-9);  // of the noise that may be left
  if (wanted >= 1) return flat;
  // The kernel (v/2, 1 - v, v/2) leaves (1 - v)^2 + v^2 / 2 of the variance along each axis.
  const double along = std::pow(wanted, 2.0 / 3);
  const double root = std::max(0.0, 1 - 1.5 * (1 - along));
  const double variance = std::min(kMostVariance, (1 - std::sqrt(root)) / 1.5);
  return volume::spread(flat, Eigen::Vector3d::Constant(variance));
}

}  // namespace facenav::segmentation
