#include "block_means.h"

#include <algorithm>
#include <cmath>

#include "facenav/volume/for_slices.h"

namespace facenav::segmentation {
namespace {

constexpr double kBlock_mm = 2.0;

}  // namespace

BlockMeans blockMeans(const volume::Volume& volume) {
  BlockMeans out;
  out.grid = volume.grid;
  Eigen::Vector3d block;
  for (int a = 0; a < 3; ++a) {
    out.block[a] = std::max(1, int(std::lround(kBlock_mm / volume.grid.spacing_mm()[a])));
    out.grid.size[a] = (volume.grid.size[a] + out.block[a] - 1) / out.block[a];
    block[a] = out.block[a];
  }
  out.grid.mri_from_voxel.translate(0.5 * (block - Eigen::Vector3d::Ones()));
  out.grid.mri_from_voxel.scale(block);
  out.mean.assign(out.grid.count(), 0.f);
  std::vector<int> count(out.mean.size());
  volume::forSlices(out.grid.size[2], [&](int slice) {
    const int end = std::min(volume.grid.size[2], (slice + 1) * out.block[2]);
    for (int k = slice * out.block[2]; k < end; ++k)
      for (int j = 0; j < volume.grid.size[1]; ++j) {
        const std::size_t row = out.grid.index(0, j / out.block[1], slice);
        std::size_t v = volume.grid.index(0, j, k);
        for (int i = 0; i < volume.grid.size[0]; ++i, ++v)
          if (std::isfinite(volume.voxels[v]))
            out.mean[row + i / out.block[0]] += volume.voxels[v], ++count[row + i / out.block[0]];
      }
  });
  for (std::size_t c = 0; c < out.mean.size(); ++c)
    out.mean[c] = count[c] ? out.mean[c] / float(count[c]) : 0.f;
  return out;
}

}  // namespace facenav::segmentation
