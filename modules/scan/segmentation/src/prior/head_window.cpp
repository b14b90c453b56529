#include "prior/head_window.h"

#include <algorithm>
#include <cmath>

#include "prior/prior_network.h"

namespace facenav::segmentation {
namespace {

constexpr double kBlack = 0.02, kWhite = 0.98;        // percentiles of the window
constexpr float kLeastValue = -0.2f, kMostValue = 2;  // as in synthesis.py
constexpr float kTiny = 1e-6f;

float valueAtShare(const std::vector<float>& sorted, double share) {
  return sorted[std::size_t(share * double(sorted.size() - 1))];
}

}  // namespace

volume::Volume headWindow(const volume::Volume& coarse, const Point<Mri>& centre) {
  const Eigen::Vector3d at = coarse.grid.toVoxel(centre);
  Eigen::Vector3i low;
  for (int a = 0; a < 3; ++a) low[a] = int(std::lround(at[a])) - kPriorSize[std::size_t(a)] / 2;
  volume::Volume window = coarse;
  window.grid.size = kPriorSize;
  window.grid.mri_from_voxel.translate(low.cast<double>());
  window.voxels.assign(window.grid.count(), 0);
  std::vector<bool> is_scanned(window.voxels.size());
  std::size_t v = 0;
  for (int k = 0; k < kPriorSize[2]; ++k)
    for (int j = 0; j < kPriorSize[1]; ++j)
      for (int i = 0; i < kPriorSize[0]; ++i, ++v) {
        const Eigen::Vector3i p = low + Eigen::Vector3i(i, j, k);
        is_scanned[v] = coarse.grid.contains(p.x(), p.y(), p.z());
        if (is_scanned[v]) window.voxels[v] = coarse.at(p.x(), p.y(), p.z());
      }
  std::vector<float> sorted = window.voxels;
  std::sort(sorted.begin(), sorted.end());
  const float black = valueAtShare(sorted, kBlack), white = valueAtShare(sorted, kWhite);
  for (std::size_t n = 0; n < window.voxels.size(); ++n)
    window.voxels[n] = is_scanned[n] ? std::clamp((window.voxels[n] - black) / (white - black + kTiny),
                                                  kLeastValue, kMostValue)
                                     : 0.f;
  return window;
}

}  // namespace facenav::segmentation
