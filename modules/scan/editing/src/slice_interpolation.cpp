#include "facenav/editing/slice_interpolation.h"

#include <algorithm>
#include <optional>

#include "facenav/core/error.h"
#include "facenav/volume/mask_morphology.h"

namespace facenav::editing {
namespace {

struct SliceAxes {
  SliceAxes(const volume::VoxelGrid& grid, int across) : w(across), u((across + 1) % 3), v((across + 2) % 3) {
    const std::array<std::size_t, 3> stride{1, std::size_t(grid.size[0]),
                                            std::size_t(grid.size[0]) * grid.size[1]};
    step_u = stride[u], step_v = stride[v], step_w = stride[w];
  }
  int w, u, v;  // w: across the slices; u, v: within a slice
  std::size_t step_u, step_v, step_w;
};

/// Signed distance to the outline in mm, > 0 inside, row-major over (v, u); nullopt for an empty slice.
std::optional<std::vector<float>> signedDistance(const volume::Mask& mask, const SliceAxes& axes, int slice) {
  const auto& grid = mask.grid;
  volume::Mask flat, hollow;
  flat.grid.size = {grid.size[axes.u], grid.size[axes.v], 1};
  const Eigen::Vector3d spacing = grid.spacing_mm();
  flat.grid.mri_from_voxel.linear() = Eigen::Vector3d(spacing[axes.u], spacing[axes.v], 1).asDiagonal();
  flat.voxels.resize(flat.grid.count());
  hollow = flat;
  std::size_t at = 0;
  bool is_empty = true;
  for (int v = 0; v < flat.grid.size[1]; ++v)
    for (int u = 0; u < flat.grid.size[0]; ++u, ++at) {
      flat.voxels[at] = mask.voxels[u * axes.step_u + v * axes.step_v + slice * axes.step_w] != 0;
      hollow.voxels[at] = !flat.voxels[at];
      is_empty = is_empty && !flat.voxels[at];
    }
  if (is_empty) return std::nullopt;
  auto distance = volume::distanceTo(hollow);
  const auto outside = volume::distanceTo(flat);
  for (std::size_t n = 0; n < distance.size(); ++n) distance[n] -= outside[n];
  return distance;
}

void addBetween(const volume::Mask& mask, const SliceAxes& axes, int from, int to, MaskChange& change) {
  if (to - from < 2) return;
  const auto first = signedDistance(mask, axes, from), last = signedDistance(mask, axes, to);
  if (!first || !last) return;
  const int nu = mask.grid.size[axes.u], nv = mask.grid.size[axes.v];
  for (int slice = from + 1; slice < to; ++slice) {
    const float share = float(slice - from) / float(to - from);
    std::size_t at = 0;
    for (int v = 0; v < nv; ++v)
      for (int u = 0; u < nu; ++u, ++at) {
        const std::size_t voxel = u * axes.step_u + v * axes.step_v + slice * axes.step_w;
        const bool is_brain = (1 - share) * (*first)[at] + share * (*last)[at] > 0;
        if ((mask.voxels[voxel] != 0) != is_brain) change.voxels.push_back(std::uint32_t(voxel));
      }
  }
}

}  // namespace

MaskChange interpolateSlices(const volume::Mask& mask, int axis, std::vector<int> slices) {
  FACENAV_EXPECT(axis >= 0 && axis < 3, "axis 0, 1 or 2");
  std::sort(slices.begin(), slices.end());
  if (!slices.empty() && (slices.front() < 0 || slices.back() >= mask.grid.size[axis]))
    throw Error("a slice to interpolate from lies outside the scan", {}, "choose slices of this scan");
  const SliceAxes axes(mask.grid, axis);
  MaskChange change;
  for (std::size_t n = 1; n < slices.size(); ++n) addBetween(mask, axes, slices[n - 1], slices[n], change);
  return change;
}

}  // namespace facenav::editing
