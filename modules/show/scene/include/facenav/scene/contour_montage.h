#pragma once
// ContourMontage: the sheet that a person checks before signing a model off. It shows slices through the
// whole brain in three orientations with the masks' contours. Computed without a display.

#include <vector>

#include "facenav/core/rgb_image.h"
#include "facenav/scene/slice_scene.h"

namespace facenav::scene {

struct MontageOptions {
  int columns = 8, tile_px = 150;  // a tile is square
  int axial_rows = 2, coronal_rows = 2, sagittal_rows = 1;
};

/// Chooses the sheet for an area of this size: five to eight rows, tiles of 60 px or more, at least two
/// fifths of the rows axial.
MontageOptions sheetFor(int width_px, int height_px);

/// Top-left pixel of a tile and the centre of its slice (in the other two axes, the middle of the content).
struct MontageTile {
  int u = 0, v = 0;
  volume::Anatomical orientation = volume::Anatomical::axial;
  Point<Mri> centre;
};

struct Montage {
  RgbImage picture;
  std::vector<MontageTile> tiles;
  int tile_px = 0;
};

/// Draws slices at equal distances through `content` (the brain's mask, or the head's if there is none). Each
/// tile shows the content with a margin. Axial from top to bottom, coronal from front to back, sagittal from
/// right to left. Empty for an empty mask. Crosshair and targets of `scene` are not drawn.
Montage contourMontage(const SliceScene& scene, const volume::Mask& content, const MontageOptions& options);

}  // namespace facenav::scene
