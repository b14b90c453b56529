#include "measured_part.h"

#include <algorithm>
#include <cmath>

namespace facenav::surface {
namespace {

using volume::VoxelGrid;

/// Calls `see(index)` for each voxel of slice `k` along `axis`, until it returns false.
template <class See>
void forSlice(const VoxelGrid& grid, int axis, int k, See see) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::array<int, 3> p{};
  p[std::size_t(axis)] = k;
  for (p[std::size_t(v)] = 0; p[std::size_t(v)] < grid.size[std::size_t(v)]; ++p[std::size_t(v)])
    for (p[std::size_t(u)] = 0; p[std::size_t(u)] < grid.size[std::size_t(u)]; ++p[std::size_t(u)])
      if (!see(grid.index(p[0], p[1], p[2]))) return;
}

bool isOfOneValue(const volume::Volume& scan, int axis, int k) {
  bool is_one = true;
  std::optional<float> value;
  forSlice(scan.grid, axis, k, [&](std::size_t at) {
    is_one = scan.voxels[at] == value.value_or(scan.voxels[at]);
    value = scan.voxels[at];
    return is_one;
  });
  return is_one;
}

double headArea_mm2(const volume::Mask& head, int axis, int k) {
  std::size_t count = 0;
  forSlice(head.grid, axis, k, [&](std::size_t at) { return count += head.voxels[at] != 0, true; });
  const Eigen::Vector3d spacing = head.grid.spacing_mm();
  return double(count) * spacing[(axis + 1) % 3] * spacing[(axis + 2) % 3];
}

/// True if the head ends flat in slice `k`: a rounded end, as of a nose, loses most of its area within 2 mm.
bool isCutAt(const volume::Mask& head, int axis, int k, int inwards) {
  constexpr double kRounded_mm = 2, kFlat = 0.5, kTouch_mm2 = 30;
  const int deeper = k + inwards * int(std::lround(kRounded_mm / head.grid.spacing_mm()[axis]));
  const double area_mm2 = headArea_mm2(head, axis, k);
  return area_mm2 > kTouch_mm2 && deeper >= 0 && deeper < head.grid.size[std::size_t(axis)] &&
         area_mm2 > kFlat * headArea_mm2(head, axis, deeper);
}

}  // namespace

MeasuredPart measuredPart(const volume::Volume& scan, const volume::Mask& head) {
  MeasuredPart part{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int a = int(axis), last = scan.grid.size[axis] - 1;
    int low = 0, high = last;
    while (low < last && isOfOneValue(scan, a, low)) ++low;
    while (high > low && isOfOneValue(scan, a, high)) --high;
    // Where one end cuts the head, what lies at the other end may be the rest of it.
    const bool is_cut =
        low < high && ((low > 0 && isCutAt(head, a, low, 1)) || (high < last && isCutAt(head, a, high, -1)));
    part.first[axis] = is_cut ? low : 0;
    part.last[axis] = is_cut ? high : last;
  }
  return part;
}

std::optional<MeasuredHead> withoutPadding(const volume::Volume& scan, const volume::Mask& head) {
  const MeasuredPart part = measuredPart(scan, head);
  VoxelGrid grid = scan.grid;
  for (std::size_t a = 0; a < 3; ++a) grid.size[a] = part.last[a] - part.first[a] + 1;
  if (grid.size == scan.grid.size) return std::nullopt;
  grid.mri_from_voxel.translation() =
      scan.grid.mri_from_voxel * Eigen::Vector3d(part.first[0], part.first[1], part.first[2]);
  MeasuredHead measured{{grid, {}, scan.modality, scan.orientation_source}, {grid, {}}};
  for (int k = part.first[2]; k <= part.last[2]; ++k)
    for (int j = part.first[1]; j <= part.last[1]; ++j) {
      const std::size_t from = scan.grid.index(part.first[0], j, k), to = from + std::size_t(grid.size[0]);
      measured.scan.voxels.insert(measured.scan.voxels.end(), scan.voxels.begin() + std::ptrdiff_t(from),
                                  scan.voxels.begin() + std::ptrdiff_t(to));
      measured.head.voxels.insert(measured.head.voxels.end(), head.voxels.begin() + std::ptrdiff_t(from),
                                  head.voxels.begin() + std::ptrdiff_t(to));
    }
  return measured;
}

}  // namespace facenav::surface
