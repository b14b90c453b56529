#include "facenav/volume/regrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "facenav/core/error.h"
#include "facenav/volume/for_slices.h"

namespace facenav::volume {
namespace {

struct Reorder {
  VoxelGrid grid;
  std::array<int, 3> source_axis;  // which source axis runs along the new axis
  std::array<bool, 3> is_flipped;
};

Reorder rasReorder(const VoxelGrid& from) {
  // The pairing of index and world axes with the greatest sum of |cosines|: unique even at 45 degrees
  // obliquity.
  const Eigen::Matrix3d l = from.mri_from_voxel.linear() * from.spacing_mm().cwiseInverse().asDiagonal();
  constexpr std::array<std::array<int, 3>, 6> kOrders{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  Reorder best;
  double best_score = -1;
  for (const auto& order : kOrders) {
    const double score = std::abs(l(0, order[0])) + std::abs(l(1, order[1])) + std::abs(l(2, order[2]));
    if (score > best_score + 1e-9) best_score = score, best.source_axis = order;
  }
  Eigen::Matrix3d linear;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  for (int a = 0; a < 3; ++a) {
    const int s = best.source_axis[a];
    best.is_flipped[a] = l(a, s) < 0;
    best.grid.size[a] = from.size[s];
    linear.col(a) = from.mri_from_voxel.linear().col(s) * (best.is_flipped[a] ? -1 : 1);
    if (best.is_flipped[a]) first[s] = from.size[s] - 1;
  }
  best.grid.mri_from_voxel.translation() = from.mri_from_voxel * first;
  best.grid.mri_from_voxel.linear() = linear;
  return best;
}

template <class Value>
std::vector<Value> reorder(const std::vector<Value>& voxels, const VoxelGrid& from, const Reorder& order) {
  std::vector<Value> out(voxels.size());
  std::size_t o = 0;
  for (int k = 0; k < order.grid.size[2]; ++k)
    for (int j = 0; j < order.grid.size[1]; ++j)
      for (int i = 0; i < order.grid.size[0]; ++i, ++o) {
        const std::array<int, 3> to{i, j, k};
        std::array<int, 3> source;
        for (int a = 0; a < 3; ++a)
          source[order.source_axis[a]] = order.is_flipped[a] ? order.grid.size[a] - 1 - to[a] : to[a];
        out[o] = voxels[from.index(source[0], source[1], source[2])];
      }
  return out;
}

}  // namespace

Volume toRasOrder(const Volume& volume) {
  const Reorder order = rasReorder(volume.grid);
  Volume out = {order.grid, reorder(volume.voxels, volume.grid, order), volume.modality,
                volume.orientation_source};
  return out;
}

Mask toRasOrder(const Mask& mask) {
  const Reorder order = rasReorder(mask.grid);
  return {order.grid, reorder(mask.voxels, mask.grid, order)};
}

namespace {

/// Steps i of a row (first + i * step) within which all coordinates lie in 0 .. n - 1 of each axis, to a
/// rounding: [begin, end).
std::pair<int, int> stepsWithin(const std::array<int, 3>& n, const Eigen::Vector3d& first,
                                const Eigen::Vector3d& step, int count) {
  constexpr double kRounding = 1e-6;  // voxels: a grid resampled onto itself keeps its border
  double from = 0, to = count - 1;
  for (int a = 0; a < 3; ++a) {
    const double low = -kRounding - first[a], high = n[a] - 1 + kRounding - first[a];
    if (std::abs(step[a]) < 1e-12) {
      if (low > 0 || high < 0) return {0, 0};
      continue;
    }
    from = std::max(from, std::min(low / step[a], high / step[a]));
    to = std::min(to, std::max(low / step[a], high / step[a]));
  }
  return to < from ? std::pair(0, 0) : std::pair(int(std::ceil(from)), int(std::floor(to)) + 1);
}

float mixed(float a, float b, float t) { return a + t * (b - a); }

/// Trilinear values along rows, eight neighbours at a time.
template <class Value, class Keep>
void sampleRows(const std::vector<Value>& voxels, const VoxelGrid& from, const VoxelGrid& to, Keep&& keep) {
  const Eigen::Affine3d from_to = from.mri_from_voxel.inverse() * to.mri_from_voxel;
  const Eigen::Vector3d step = from_to.linear().col(0);
  const auto& n = from.size;
  const std::size_t row = n[0], slab = row * n[1];
  const std::size_t di = n[0] > 1, dj = n[1] > 1 ? row : 0, dk = n[2] > 1 ? slab : 0;
  forSlices(to.size[2], [&](int k) {
    for (int j = 0; j < to.size[1]; ++j) {
      const Eigen::Vector3d first = from_to * Eigen::Vector3d(0, j, k);
      const auto [begin, end] = stepsWithin(n, first, step, to.size[0]);
      const std::size_t out = to.index(0, j, k);
      for (int i = begin; i < end; ++i) {
        int low[3];
        float part[3];
        for (int a = 0; a < 3; ++a) {
          const double at = std::clamp(first[a] + i * step[a], 0.0, double(n[a] - 1));
          low[a] = std::min(int(at), std::max(0, n[a] - 2));
          part[a] = float(at - low[a]);
        }
        const Value* v = &voxels[from.index(low[0], low[1], low[2])];
        const auto line = [&](const Value* p) { return mixed(float(p[0]), float(p[di]), part[0]); };
        keep(out + i, mixed(mixed(line(v), line(v + dj), part[1]),
                            mixed(line(v + dk), line(v + dj + dk), part[1]), part[2]));
      }
    }
  });
}

}  // namespace

Volume resample(const Volume& volume, const VoxelGrid& grid) {
  Volume out{grid, std::vector<float>(grid.count()), volume.modality, volume.orientation_source};
  if (volume.grid.count() > 0)
    sampleRows(volume.voxels, volume.grid, grid,
               [&](std::size_t at, float value) { out.voxels[at] = value; });
  return out;
}

Mask resample(const Mask& mask, const VoxelGrid& grid) {
  Mask out{grid, std::vector<std::uint8_t>(grid.count())};
  if (mask.grid.count() > 0)
    sampleRows(mask.voxels, mask.grid, grid,
               [&](std::size_t at, float value) { out.voxels[at] = value >= 0.5f; });
  return out;
}

VoxelGrid isotropicGrid(const VoxelGrid& grid, double spacing_mm) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e30), high = -low;
  for (int c = 0; c < 8; ++c) {
    const Eigen::Vector3d ijk((c & 1) * (grid.size[0] - 1), ((c >> 1) & 1) * (grid.size[1] - 1),
                              (c >> 2) * (grid.size[2] - 1));
    low = low.cwiseMin(grid.toMri(ijk).mm);
    high = high.cwiseMax(grid.toMri(ijk).mm);
  }
  VoxelGrid out;
  for (int a = 0; a < 3; ++a) out.size[a] = int(std::ceil((high[a] - low[a]) / spacing_mm - 1e-6)) + 1;
  out.mri_from_voxel.linear() = Eigen::Matrix3d::Identity() * spacing_mm;
  out.mri_from_voxel.translation() = low;
  return out;
}

VoxelGrid gridAround(const Mask& mask, double spacing_mm, double margin_mm) {
  Eigen::AlignedBox3d box;
  for (int k = 0; k < mask.grid.size[2]; ++k)
    for (int j = 0; j < mask.grid.size[1]; ++j) {
      const std::uint8_t* row = &mask.voxels[mask.grid.index(0, j, k)];
      int first = 0, last = mask.grid.size[0] - 1;
      while (first <= last && !row[first]) ++first;
      while (last > first && !row[last]) --last;
      if (first > last) continue;
      box.extend(mask.grid.toMri({double(first), double(j), double(k)}).mm);
      box.extend(mask.grid.toMri({double(last), double(j), double(k)}).mm);
    }
  if (box.isEmpty()) throw Error("the mask is empty", {}, "segment the brain, or paint it");
  VoxelGrid grid;
  for (int a = 0; a < 3; ++a)
    grid.size[a] = 2 + int(std::ceil((box.sizes()[a] + 2 * margin_mm) / spacing_mm));
  grid.mri_from_voxel =
      Eigen::Translation3d(box.min() - Eigen::Vector3d::Constant(margin_mm)) * Eigen::Scaling(spacing_mm);
  return grid;
}

}  // namespace facenav::volume
