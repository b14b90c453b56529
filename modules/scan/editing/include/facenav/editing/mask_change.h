#pragma once
// MaskChange: an edit of a mask, as the list of voxels that flip. Flipping them again undoes it, so one list
// serves undo and redo. PackedChange is the same list packed into bytes: runs of neighbouring voxels (gap,
// length) as base-128 numbers. It needs a few bytes per row of voxels, so an unlimited history stays small.

#include <cstdint>
#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::editing {

struct MaskChange {
  std::vector<std::uint32_t> voxels;  // indices into Mask::voxels, each once

  bool empty() const { return voxels.empty(); }
  std::size_t size() const { return voxels.size(); }
};

struct PackedChange {
  std::vector<std::uint8_t> bytes;
  std::size_t voxel_count = 0;
};

PackedChange pack(MaskChange change);
MaskChange unpack(const PackedChange& packed);
/// Both changes one after the other: the voxels that are in exactly one of them.
MaskChange merged(MaskChange first, MaskChange second);
void flip(volume::Mask& mask, const MaskChange& change);
/// The voxels that differ. Throws Error unless both grids match.
MaskChange difference(const volume::Mask& from, const volume::Mask& to);

}  // namespace facenav::editing
