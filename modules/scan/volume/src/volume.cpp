#include "facenav/volume/volume.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "facenav/core/error.h"
#include "facenav/core/robust_statistics.h"

namespace facenav::volume {

double Mask::volume_ml() const {
  const auto count = std::count_if(voxels.begin(), voxels.end(), [](std::uint8_t v) { return v != 0; });
  return double(count) * grid.voxelVolume_mm3() / 1000.0;
}

namespace {

template <class Value>
float linearAt(const VoxelGrid& grid, const std::vector<Value>& voxels, const Eigen::Vector3d& ijk,
               float outside) {
  constexpr double kRounding = 1e-6;  // voxels: keeps the border when a grid is resampled onto itself
  const auto& n = grid.size;
  for (int a = 0; a < 3; ++a)
    if (!(ijk[a] >= -kRounding && ijk[a] <= n[a] - 1 + kRounding)) return outside;
  const int i = std::min(int(ijk[0]), std::max(0, n[0] - 2)),
            j = std::min(int(ijk[1]), std::max(0, n[1] - 2)),
            k = std::min(int(ijk[2]), std::max(0, n[2] - 2));
  const std::size_t di = n[0] > 1, dj = n[1] > 1 ? std::size_t(n[0]) : 0,
                    dk = n[2] > 1 ? std::size_t(n[0]) * std::size_t(n[1]) : 0;
  const auto within = [](double t) { return float(std::clamp(t, 0.0, 1.0)); };
  const float x = within(ijk[0] - i), y = within(ijk[1] - j), z = within(ijk[2] - k);
  const auto mix = [](float a, float b, float t) { return a + t * (b - a); };
  const Value* first = &voxels[grid.index(i, j, k)];
  const auto row = [&](const Value* v) { return mix(float(v[0]), float(v[di]), x); };
  return mix(mix(row(first), row(first + dj), y), mix(row(first + dk), row(first + dj + dk), y), z);
}

}  // namespace

float sampleLinear(const Volume& volume, const Eigen::Vector3d& ijk, float outside) {
  return linearAt(volume.grid, volume.voxels, ijk, outside);
}

float sampleLinear(const Mask& mask, const Eigen::Vector3d& ijk, float outside) {
  return linearAt(mask.grid, mask.voxels, ijk, outside);
}

std::optional<float> valueAt(const Volume& volume, const Point<Mri>& p) {
  const Eigen::Vector3d nearest = volume.grid.toVoxel(p).array().round();
  for (int a = 0; a < 3; ++a)
    if (!(nearest[a] >= 0 && nearest[a] < volume.grid.size[std::size_t(a)])) return std::nullopt;
  return volume.at(int(nearest.x()), int(nearest.y()), int(nearest.z()));
}

float percentile(const Volume& volume, double fraction) {
  constexpr std::size_t kMostSamples = 2'000'000;
  const std::size_t step = std::max<std::size_t>(1, volume.voxels.size() / kMostSamples);
  std::vector<float> sample;
  sample.reserve(volume.voxels.size() / step + 1);
  for (std::size_t i = 0; i < volume.voxels.size(); i += step)
    if (std::isfinite(volume.voxels[i])) sample.push_back(volume.voxels[i]);
  if (sample.empty()) throw Error("the volume holds no finite voxel");
  return selectRank(sample, std::size_t(fraction * double(sample.size())));
}

Overlap overlap(const Mask& a, const Mask& b) {
  if (!a.grid.matches(b.grid))
    throw Error("masks lie on different grids", {}, "resample one onto the other first");
  std::size_t both = 0, in_a = 0, in_b = 0;
  for (std::size_t i = 0; i < a.voxels.size(); ++i) {
    in_a += a.voxels[i] != 0;
    in_b += b.voxels[i] != 0;
    both += a.voxels[i] && b.voxels[i];
  }
  if (in_a == 0 || in_b == 0) return {0.0, 0.0};
  return {2.0 * both / double(in_a + in_b), double(both) / in_a};
}

}  // namespace facenav::volume
