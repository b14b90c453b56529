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
  std::array<int, 3> source_axis;  // for each new axis, the source axis along it
  std::array<bool, 3> is_flipped;
};

Reorder rasReorder(const VoxelGrid& from) {
  // The pairing of index and world axes with the largest sum of |cosines|. It is unique even at 45 degrees
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
  const std::array<std::ptrdiff_t, 3> stride{1, from.size[0], std::ptrdiff_t(from.size[0]) * from.size[1]};
  std::array<std::ptrdiff_t, 3> step;
  std::ptrdiff_t first = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    step[a] = stride[std::size_t(order.source_axis[a])] * (order.is_flipped[a] ? -1 : 1);
    if (order.is_flipped[a]) first -= step[a] * (order.grid.size[a] - 1);
  }
  const auto& n = order.grid.size;
  forSlices(n[2], [&](int k) {
    for (int j = 0; j < n[1]; ++j) {
      const Value* source = voxels.data() + first + j * step[1] + k * step[2];
      Value* to = out.data() + order.grid.index(0, j, k);
      if (step[0] == 1)
        std::copy_n(source, n[0], to);
      else
        for (int i = 0; i < n[0]; ++i) to[i] = source[i * step[0]];
    }
  });
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

/// Steps i of a row (first + i * step) at which all coordinates are within 0 .. n - 1 of each axis, apart
/// from rounding: [begin, end).
std::pair<int, int> stepsWithin(const std::array<int, 3>& n, const Eigen::Vector3d& first,
                                const Eigen::Vector3d& step, int count) {
  constexpr double kRounding = 1e-6;  // voxels: keeps the border when a grid is resampled onto itself
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

/// The lower neighbour of a position and the fraction beyond it, per axis.
struct Between {
  int low[3];
  float part[3];

  Between(const std::array<int, 3>& n, const Eigen::Vector3d& at) {
    for (int a = 0; a < 3; ++a) {
      const double x = std::clamp(at[a], 0.0, double(n[a] - 1));
      low[a] = std::min(int(x), std::max(0, n[a] - 2));
      part[a] = float(x - low[a]);
    }
  }
};

/// Calls keep(index in `to`, position in `from`) for every voxel of `to` that lies within `from`.
template <class Keep>
void forRows(const VoxelGrid& from, const VoxelGrid& to, Keep&& keep) {
  if (from.count() == 0) return;
  const Eigen::Affine3d from_to = from.mri_from_voxel.inverse() * to.mri_from_voxel;
  const Eigen::Vector3d step = from_to.linear().col(0);
  forSlices(to.size[2], [&](int k) {
    for (int j = 0; j < to.size[1]; ++j) {
      const Eigen::Vector3d first = from_to * Eigen::Vector3d(0, j, k);
      const auto [begin, end] = stepsWithin(from.size, first, step, to.size[0]);
      const std::size_t out = to.index(0, j, k);
      for (int i = begin; i < end; ++i) keep(out + std::size_t(i), Between(from.size, first + i * step));
    }
  });
}

struct AsFloat {
  template <class Value>
  float operator()(Value value) const {
    return float(value);
  }
};

/// Height above a floor; 0 for a value that is not finite.
struct AboveFloor {
  float floor;
  float operator()(float value) const { return std::isfinite(value) ? value - floor : 0.f; }
};

/// Trilinear value from eight neighbours, each as `read` gives it.
template <class Value, class Read = AsFloat>
struct Linear {
  Linear(const std::vector<Value>& values, const VoxelGrid& on, Read how = {})
      : voxels(values),
        grid(on),
        read(how),
        di(on.size[0] > 1),
        dj(on.size[1] > 1 ? std::size_t(on.size[0]) : 0),
        dk(on.size[2] > 1 ? std::size_t(on.size[0]) * on.size[1] : 0) {}
  float operator()(const Between& at) const {
    const Value* v = &voxels[grid.index(at.low[0], at.low[1], at.low[2])];
    const auto line = [&](const Value* p) { return mixed(read(p[0]), read(p[di]), at.part[0]); };
    return mixed(mixed(line(v), line(v + dj), at.part[1]), mixed(line(v + dk), line(v + dj + dk), at.part[1]),
                 at.part[2]);
  }
  const std::vector<Value>& voxels;
  const VoxelGrid& grid;
  Read read;
  std::size_t di, dj, dk;
};

/// Weights of the four neighbours of a position at fraction `t` after the second.
std::array<float, 4> cubicWeights(float t) {
  const float t2 = t * t, t3 = t2 * t;
  return {0.5f * (-t3 + 2 * t2 - t), 0.5f * (3 * t3 - 5 * t2 + 2), 0.5f * (-3 * t3 + 4 * t2 + t),
          0.5f * (t3 - t2)};
}

/// Cubic value from 64 neighbours, all within the grid; four of a row at a time.
float cubicInside(const float* first, std::size_t row, std::size_t slab,
                  const std::array<std::array<float, 4>, 3>& weight) {
  Eigen::Array4f sum = Eigen::Array4f::Zero();
  for (std::size_t c = 0; c < 4; ++c) {
    if (weight[2][c] == 0) continue;
    for (std::size_t b = 0; b < 4; ++b)
      sum += weight[2][c] * weight[1][b] * Eigen::Map<const Eigen::Array4f>(first + c * slab + b * row);
  }
  return (sum * Eigen::Map<const Eigen::Array4f>(weight[0].data())).sum();
}

/// Cubic value from 64 neighbours; the grid's edge is repeated.
float cubicAt(const Volume& volume, const Between& at) {
  const auto& n = volume.grid.size;
  std::array<std::array<float, 4>, 3> weight;
  std::array<std::array<std::size_t, 4>, 3> offset;
  const std::array<std::size_t, 3> stride{1, std::size_t(n[0]), std::size_t(n[0]) * n[1]};
  bool is_inside = true;
  for (std::size_t a = 0; a < 3; ++a) {
    weight[a] = cubicWeights(at.part[a]);
    is_inside &= at.low[a] >= 1 && at.low[a] + 2 < n[a];
  }
  if (is_inside)
    return cubicInside(&volume.voxels[volume.grid.index(at.low[0] - 1, at.low[1] - 1, at.low[2] - 1)],
                       stride[1], stride[2], weight);
  for (std::size_t a = 0; a < 3; ++a) {
    for (int c = 0; c < 4; ++c)
      offset[a][std::size_t(c)] = std::size_t(std::clamp(at.low[a] - 1 + c, 0, n[a] - 1)) * stride[a];
  }
  float sum = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    if (weight[2][c] == 0) continue;
    float plane = 0;
    for (std::size_t b = 0; b < 4; ++b) {
      if (weight[1][b] == 0) continue;
      const float* row = &volume.voxels[offset[2][c] + offset[1][b]];
      float line = 0;
      for (std::size_t a = 0; a < 4; ++a) line += weight[0][a] * row[offset[0][a]];
      plane += weight[1][b] * line;
    }
    sum += weight[2][c] * plane;
  }
  return sum;
}

}  // namespace

std::optional<Mask> reordered(const Mask& mask, const VoxelGrid& grid) {
  if (mask.grid.count() != grid.count()) return std::nullopt;
  const Eigen::Affine3d there_from_here = mask.grid.mri_from_voxel.inverse() * grid.mri_from_voxel;
  const Eigen::Matrix3i turn = there_from_here.linear().array().round().matrix().cast<int>();
  const Eigen::Vector3i shift = there_from_here.translation().array().round().matrix().cast<int>();
  if (turn.cwiseAbs().rowwise().sum() != Eigen::Vector3i::Ones()) return std::nullopt;
  const auto isSameCorner = [&](const Eigen::Vector3i& here) {
    const Eigen::Vector3i there = turn * here + shift;
    return mask.grid.contains(there.x(), there.y(), there.z()) &&
           (mask.grid.toMri(there.cast<double>()).mm - grid.toMri(here.cast<double>()).mm).norm() < 1e-3;
  };
  for (int corner = 0; corner < 8; ++corner)
    if (!isSameCorner({corner & 1 ? grid.size[0] - 1 : 0, corner & 2 ? grid.size[1] - 1 : 0,
                       corner & 4 ? grid.size[2] - 1 : 0}))
      return std::nullopt;
  Mask result{grid, std::vector<std::uint8_t>(grid.count())};
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const Eigen::Vector3i there = turn * Eigen::Vector3i(i, j, k) + shift;
        result.voxels[grid.index(i, j, k)] = mask.at(there.x(), there.y(), there.z());
      }
  return result;
}

Volume resample(const Volume& volume, const VoxelGrid& grid) {
  Volume out{grid, std::vector<float>(grid.count()), volume.modality, volume.orientation_source};
  const Linear<float> sample(volume.voxels, volume.grid);
  forRows(volume.grid, grid, [&](std::size_t v, const Between& at) { out.voxels[v] = sample(at); });
  return out;
}

Volume resampleAbove(const Volume& volume, float floor, const VoxelGrid& grid) {
  Volume out{grid, std::vector<float>(grid.count()), volume.modality, volume.orientation_source};
  const Linear<float, AboveFloor> sample(volume.voxels, volume.grid, {floor});
  forRows(volume.grid, grid, [&](std::size_t v, const Between& at) { out.voxels[v] = sample(at); });
  return out;
}

Volume resampleCubic(const Volume& volume, const VoxelGrid& grid) {
  Volume out{grid, std::vector<float>(grid.count()), volume.modality, volume.orientation_source};
  forRows(volume.grid, grid, [&](std::size_t v, const Between& at) { out.voxels[v] = cubicAt(volume, at); });
  return out;
}

Mask resampledAbove(const Volume& volume, float least, const VoxelGrid& grid) {
  Mask out{grid, std::vector<std::uint8_t>(grid.count(), 0 >= least)};
  const Linear<float> sample(volume.voxels, volume.grid);
  forRows(volume.grid, grid, [&](std::size_t v, const Between& at) { out.voxels[v] = sample(at) >= least; });
  return out;
}

Volume shareOn(const Mask& mask, const VoxelGrid& grid) {
  Volume out{grid, std::vector<float>(grid.count()), {}, {}};
  const Linear<std::uint8_t> sample(mask.voxels, mask.grid);
  forRows(mask.grid, grid, [&](std::size_t v, const Between& at) { out.voxels[v] = sample(at); });
  return out;
}

Mask resample(const Mask& mask, const VoxelGrid& grid) {
  Mask out{grid, std::vector<std::uint8_t>(grid.count())};
  const Linear<std::uint8_t> sample(mask.voxels, mask.grid);
  forRows(mask.grid, grid, [&](std::size_t v, const Between& at) { out.voxels[v] = sample(at) >= 0.5f; });
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
