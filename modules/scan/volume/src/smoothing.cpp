#include "facenav/volume/smoothing.h"

#include <algorithm>

#include "facenav/volume/for_slices.h"

namespace facenav::volume {
namespace {

/// out[i] = (1 - 2 side) b[i] + side (a[i] + c[i]), for `width` values.
void mixRows(const float* a, const float* b, const float* c, float* out, std::size_t width, float side) {
  const float middle = 1 - 2 * side;
  for (std::size_t i = 0; i < width; ++i) out[i] = middle * b[i] + side * (a[i] + c[i]);
}

}  // namespace

Volume smoothed(Volume volume) { return spread(std::move(volume), Eigen::Vector3d::Constant(0.5)); }

Volume spread(Volume volume, const Eigen::Vector3d& variance) {
  const Eigen::Vector3f side = (variance / 2).cast<float>();
  const auto& n = volume.grid.size;
  const std::size_t row = n[0], slab = row * n[1];
  std::vector<float> along(volume.voxels.size());
  forSlices(n[2], [&](int k) {
    std::vector<float> rows(slab);
    const float* in = &volume.voxels[k * slab];
    for (int j = 0; j < n[1]; ++j) {
      const float* from = in + j * row;
      float* to = &rows[j * row];
      to[0] = from[0], to[row - 1] = from[row - 1];
      if (row > 2) mixRows(from, from + 1, from + 2, to + 1, row - 2, side.x());
    }
    float* out = &along[k * slab];
    std::copy_n(rows.data(), row, out);
    for (int j = 1; j + 1 < n[1]; ++j)
      mixRows(&rows[(j - 1) * row], &rows[j * row], &rows[(j + 1) * row], out + j * row, row, side.y());
    std::copy_n(&rows[slab - row], row, out + slab - row);
  });
  forSlices(n[2], [&](int k) {
    float* out = &volume.voxels[k * slab];
    if (k == 0 || k + 1 == n[2])
      std::copy_n(&along[k * slab], slab, out);
    else
      mixRows(&along[(k - 1) * slab], &along[k * slab], &along[(k + 1) * slab], out, slab, side.z());
  });
  return volume;
}

}  // namespace facenav::volume
