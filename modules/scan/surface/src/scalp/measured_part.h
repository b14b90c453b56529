#pragma once
// The part of a scan that was measured. Scanners and programs pad scans with slices of one value; a head that
// ends flat at such slices is cut there, as at the end of the grid.

#include <array>
#include <optional>

#include "facenav/volume/volume.h"

namespace facenav::surface {

/// First and last slice of the measured part along each voxel axis.
struct MeasuredPart {
  std::array<int, 3> first, last;
};

/// The whole grid; along an axis where slices of one value cut `head`, without such slices at both ends.
MeasuredPart measuredPart(const volume::Volume& scan, const volume::Mask& head);

/// Scan and head within their measured part; nullopt if that is the whole grid.
struct MeasuredHead {
  volume::Volume scan;
  volume::Mask head;
};
std::optional<MeasuredHead> withoutPadding(const volume::Volume& scan, const volume::Mask& head);

}  // namespace facenav::surface
