#pragma once
// Brush and eraser: a ball, or a disc in the slice that is shown, drawn from one place to the next of a
// stroke. With a range of values it paints only voxels of that intensity (threshold paint).

#include <optional>

#include "facenav/editing/mask_change.h"

namespace facenav::editing {

struct BrushPath {
  Point<Mri> from, to;  // where the pointer was and is; the same for a click
};

struct Brush {
  double radius_mm = 5;
  /// Across the slice shown: then the brush is a disc one voxel thick. Nothing: a ball.
  std::optional<Direction<Mri>> slice_normal;
};

struct ValueRange {
  float low, high;  // both belong to it
  bool contains(float value) const { return value >= low && value <= high; }
};

/// The voxels whose centres the brush covers and that are not `is_brain` yet.
MaskChange paint(const volume::Mask& mask, const BrushPath& path, const Brush& brush, bool is_brain);
/// Only where the volume's value lies in `range`. `volume` lies on the mask's grid.
MaskChange paintWithin(const volume::Mask& mask, const volume::Volume& volume, const ValueRange& range,
                       const BrushPath& path, const Brush& brush, bool is_brain);

}  // namespace facenav::editing
