#pragma once
// Brush and eraser: a ball, or a disc in the displayed slice, moved along a stroke. With a range of values it
// changes only voxels of that intensity (threshold paint).

#include <optional>

#include "facenav/editing/mask_change.h"

namespace facenav::editing {

struct BrushPath {
  Point<Mri> from, to;  // previous and current pointer position; equal for a click
};

struct Brush {
  double radius_mm = 5;
  /// Normal of the displayed slice: the brush is a disc one voxel thick. nullopt: the brush is a ball.
  std::optional<Direction<Mri>> slice_normal;
};

struct ValueRange {
  float low, high;  // both limits are included
  bool contains(float value) const { return value >= low && value <= high; }
};

/// The voxels whose centres are under the brush and whose value differs from `is_brain`.
MaskChange paint(const volume::Mask& mask, const BrushPath& path, const Brush& brush, bool is_brain);
/// Limits paint() to voxels whose value lies in `range`. `volume` is on the mask's grid.
MaskChange paintWithin(const volume::Mask& mask, const volume::Volume& volume, const ValueRange& range,
                       const BrushPath& path, const Brush& brush, bool is_brain);

}  // namespace facenav::editing
