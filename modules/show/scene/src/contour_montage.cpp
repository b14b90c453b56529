#include "facenav/scene/contour_montage.h"

#include <algorithm>
#include <limits>

namespace facenav::scene {
namespace {

constexpr double kMargin_mm = 14.0;  // skull and skin around the brain help to judge its outline
constexpr int kGap_px = 3;

struct Box {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::max()), high = -low;
  bool isEmpty() const { return low.x() > high.x(); }
};

/// Bounds of the set voxels' centres, Mri, mm.
Box boxOf(const volume::Mask& mask) {
  Box box;
  const auto& n = mask.grid.size;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        if (!mask.at(i, j, k)) continue;
        const Eigen::Vector3d p = mask.grid.toMri(Eigen::Vector3d(i, j, k)).mm;
        box.low = box.low.cwiseMin(p);
        box.high = box.high.cwiseMax(p);
      }
  return box;
}

int normalAxis(volume::Anatomical orientation) {
  return orientation == volume::Anatomical::axial ? 2 : orientation == volume::Anatomical::coronal ? 1 : 0;
}

/// Anatomical plane with its centre at `centre`, `side_mm` wide and high.
volume::SlicePlane tilePlane(const SliceScene& scene, volume::Anatomical orientation,
                             const Point<Mri>& centre, double side_mm, int tile_px) {
  auto plane = volume::anatomicalPlane(scene.mri->grid, orientation, centre);
  plane.spacing_mm = side_mm / tile_px;
  plane.width = plane.height = tile_px;
  const double half = 0.5 * (tile_px - 1) * plane.spacing_mm;
  plane.origin = Point<Mri>(centre.mm - half * (plane.right.v + plane.down.v));
  return plane;
}

void pasteTile(RgbImage& sheet, const RgbImage& tile, int u, int v) {
  for (int row = 0; row < tile.height_px; ++row)
    std::copy_n(tile.pixel(0, row), 3 * std::size_t(tile.width_px), sheet.pixel(u, v + row));
}

}  // namespace

MontageOptions sheetFor(int width_px, int height_px) {
  MontageOptions best;
  double best_area = -1;
  for (int rows = 5; rows <= 8; ++rows)
    for (int columns = 4; columns <= 16; ++columns) {
      const int tile_px = std::max(60, std::min(width_px / columns, height_px / rows) - kGap_px);
      const double area = double(rows) * columns * tile_px * tile_px;
      if (columns * (tile_px + kGap_px) > std::max(width_px, 4 * 63) || area <= best_area * 1.02) continue;
      best_area = area;
      best.columns = columns;
      best.tile_px = tile_px;
      best.sagittal_rows = rows / 4;
      best.coronal_rows = (rows - best.sagittal_rows) / 2;
      best.axial_rows = rows - best.sagittal_rows - best.coronal_rows;
    }
  return best;
}

Montage contourMontage(const SliceScene& scene, const volume::Mask& content, const MontageOptions& options) {
  Montage montage;
  const Box box = boxOf(content);
  if (!scene.mri || box.isEmpty()) return montage;
  SliceScene plain = scene;
  plain.crosshair.reset();
  plain.targets.clear();
  const int pitch = options.tile_px + kGap_px;
  const int rows[3] = {options.axial_rows, options.coronal_rows, options.sagittal_rows};
  const volume::Anatomical orientations[3] = {volume::Anatomical::axial, volume::Anatomical::coronal,
                                              volume::Anatomical::sagittal};
  montage.tile_px = options.tile_px;
  montage.picture = RgbImage(options.columns * pitch, (rows[0] + rows[1] + rows[2]) * pitch);
  const double side_mm = (box.high - box.low).maxCoeff() + 2 * kMargin_mm;
  int first_row = 0;
  for (int o = 0; o < 3; first_row += rows[o], ++o) {
    const int axis = normalAxis(orientations[o]), count = rows[o] * options.columns;
    for (int i = 0; i < count; ++i) {
      Point<Mri> centre(0.5 * (box.low + box.high));
      const double fraction = (i + 0.5) / count;  // starts at the top, front and right
      centre.mm[axis] = box.high[axis] - fraction * (box.high[axis] - box.low[axis]);
      MontageTile tile{i % options.columns * pitch, (first_row + i / options.columns) * pitch,
                       orientations[o], centre};
      plain.has_letters = i == 0;
      pasteTile(montage.picture,
                plain.picture(tilePlane(scene, orientations[o], centre, side_mm, options.tile_px)), tile.u,
                tile.v);
      montage.tiles.push_back(tile);
    }
  }
  return montage;
}

}  // namespace facenav::scene
