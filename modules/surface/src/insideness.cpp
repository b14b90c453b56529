#include "insideness.h"

#include <array>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/volume/regrid.h"

namespace facenav::surface {
namespace {

using Eigen::Vector3d;
using volume::Mask;
using volume::Volume;
using volume::VoxelGrid;

/// The smallest axis-aligned grid around the mask, with a margin for smoothing.
VoxelGrid gridAround(const Mask& brain, double spacing_mm) {
  Vector3d low = Vector3d::Constant(1e9), high = Vector3d::Constant(-1e9);
  for (int k = 0; k < brain.grid.size[2]; ++k)
    for (int j = 0; j < brain.grid.size[1]; ++j)
      for (int i = 0; i < brain.grid.size[0]; ++i) {
        if (!brain.at(i, j, k)) continue;
        const Vector3d p = brain.grid.mri_from_voxel * Vector3d(i, j, k);
        low = low.cwiseMin(p), high = high.cwiseMax(p);
      }
  if (high.x() < low.x()) throw Error("the brain mask is empty", {}, "segment the brain, or paint it");
  const Vector3d margin =
      brain.grid.spacing_mm().maxCoeff() * Vector3d::Ones() + Vector3d::Constant(3 * spacing_mm);
  VoxelGrid grid;
  for (int a = 0; a < 3; ++a) grid.size[a] = 2 + int(std::ceil((high - low + 2 * margin)[a] / spacing_mm));
  grid.mri_from_voxel = Eigen::Translation3d(low - margin) * Eigen::Scaling(spacing_mm);
  return grid;
}

/// One pass of the kernel 1-2-1 along each axis: sigma 0.7 voxels, which turns the mask's steps into a slope.
void smooth(Volume& v) {
  const auto& n = v.grid.size;
  const std::array<std::size_t, 3> stride{1, std::size_t(n[0]), std::size_t(n[0]) * n[1]};
  for (int a = 0; a < 3; ++a) {
    const std::vector<float> from = v.voxels;
    for (std::size_t i = stride[a]; i + stride[a] < from.size(); ++i)
      v.voxels[i] = 0.25f * (from[i - stride[a]] + 2 * from[i] + from[i + stride[a]]);
  }
}

}  // namespace

Volume insideness(const Mask& mask, double spacing_mm) {
  Volume inside;
  inside.grid = mask.grid;
  inside.voxels.assign(mask.voxels.begin(), mask.voxels.end());
  inside = volume::resample(inside, gridAround(mask, spacing_mm));
  smooth(inside);
  return inside;
}

}  // namespace facenav::surface
