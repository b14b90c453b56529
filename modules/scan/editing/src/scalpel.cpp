#include "facenav/editing/scalpel.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "voxel_box.h"

namespace facenav::editing {
namespace {

struct Hit {
  std::uint32_t voxel;
  Eigen::Vector2d screen;
  double depth_mm;
};

/// The mask's voxels behind the outline.
std::vector<Hit> voxelsBehind(const volume::Mask& mask, const ScalpelView& view, const Outline& outline) {
  Eigen::AlignedBox2d around;
  for (const auto& corner : outline) around.extend(corner);
  const Eigen::Matrix4d screen_from_voxel = view.screen_from_mri * mask.grid.mri_from_voxel.matrix();
  const VoxelBox box = boxOf(mask, 0);
  std::vector<Hit> hits;
  for (int k = box.low[2]; k <= box.high[2]; ++k)
    for (int j = box.low[1]; j <= box.high[1]; ++j) {
      Eigen::Vector4d h = screen_from_voxel * Eigen::Vector4d(box.low[0], j, k, 1);
      for (int i = box.low[0]; i <= box.high[0]; ++i, h += screen_from_voxel.col(0)) {
        const std::size_t v = mask.grid.index(i, j, k);
        if (!mask.voxels[v] || h[3] <= 0) continue;
        const Eigen::Vector2d p = h.head<2>() / h[3];
        if (!around.contains(p) || !isInside(outline, p)) continue;
        const double depth_mm = (mask.grid.toMri({double(i), double(j), double(k)}).mm - view.eye.mm).norm();
        hits.push_back({std::uint32_t(v), p, depth_mm});
      }
    }
  return hits;
}

/// Distance of two neighbouring voxels on the screen, so that no cell of the depth map between voxels is
/// empty.
double cellSize(const volume::Mask& mask, const ScalpelView& view, const Hit& hit) {
  const int row = mask.grid.size[0], column = mask.grid.size[1];
  const Eigen::Vector4d at(hit.voxel % row, hit.voxel / row % column, hit.voxel / row / column, 1);
  const Eigen::Matrix4d screen_from_voxel = view.screen_from_mri * mask.grid.mri_from_voxel.matrix();
  double size = 0;
  for (int a = 0; a < 3; ++a) {
    const Eigen::Vector4d next = screen_from_voxel * (at + Eigen::Vector4d::Unit(a));
    size = std::max(size, (next.head<2>() / next[3] - hit.screen).norm());
  }
  return std::max(1e-9, 1.5 * size);
}

}  // namespace

MaskChange cut(const volume::Mask& mask, const ScalpelView& view, const Outline& outline, double depth_mm) {
  MaskChange change;
  if (outline.size() < 3) return change;
  const auto hits = voxelsBehind(mask, view, outline);
  if (hits.empty()) return change;
  const double cell = cellSize(mask, view, hits.front());
  const auto cellOf = [&](const Hit& hit) {
    return std::pair{std::lround(hit.screen.x() / cell), std::lround(hit.screen.y() / cell)};
  };
  std::map<std::pair<long, long>, double> nearest_mm;
  if (depth_mm > 0)
    for (const Hit& hit : hits) {
      auto& nearest = nearest_mm.try_emplace(cellOf(hit), hit.depth_mm).first->second;
      nearest = std::min(nearest, hit.depth_mm);
    }
  for (const Hit& hit : hits)
    if (depth_mm <= 0 || hit.depth_mm <= nearest_mm.at(cellOf(hit)) + depth_mm)
      change.voxels.push_back(hit.voxel);
  return change;
}

}  // namespace facenav::editing
