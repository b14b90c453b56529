#pragma once
// MaskChange: what an edit does to a mask, as the voxels that flip. Flipping them again undoes it, so that
// one list serves undo and redo. PackedChange is the same as bytes: runs of neighbours (gap, length) in
// base-128 numbers, a few bytes per row of voxels, so that an unlimited history stays small.

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
/// What both do one after the other: voxels in exactly one of them.
MaskChange merged(MaskChange first, MaskChange second);
void flip(volume::Mask& mask, const MaskChange& change);
/// The voxels in which they differ. Throws Error unless both grids match.
MaskChange difference(const volume::Mask& from, const volume::Mask& to);

}  // namespace facenav::editing
