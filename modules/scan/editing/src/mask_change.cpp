#include "facenav/editing/mask_change.h"

#include <algorithm>
#include <iterator>

#include "facenav/core/error.h"

namespace facenav::editing {
namespace {

void putNumber(std::uint32_t number, std::vector<std::uint8_t>& bytes) {
  for (; number >= 0x80; number >>= 7) bytes.push_back(std::uint8_t(number | 0x80));
  bytes.push_back(std::uint8_t(number));
}

std::uint32_t takeNumber(std::vector<std::uint8_t>::const_iterator& at) {
  std::uint32_t number = 0;
  for (int shift = 0;; shift += 7) {
    const std::uint8_t byte = *at++;
    number |= std::uint32_t(byte & 0x7f) << shift;
    if (byte < 0x80) return number;
  }
}

}  // namespace

PackedChange pack(MaskChange change) {
  std::sort(change.voxels.begin(), change.voxels.end());
  PackedChange packed;
  packed.voxel_count = change.voxels.size();
  std::uint32_t end = 0;  // end of the previous run
  for (std::size_t n = 0; n < change.voxels.size();) {
    const std::uint32_t start = change.voxels[n];
    std::uint32_t length = 0;
    while (n < change.voxels.size() && change.voxels[n] == start + length) ++n, ++length;
    putNumber(start - end, packed.bytes);
    putNumber(length, packed.bytes);
    end = start + length;
  }
  packed.bytes.shrink_to_fit();
  return packed;
}

MaskChange unpack(const PackedChange& packed) {
  MaskChange change;
  change.voxels.reserve(packed.voxel_count);
  std::uint32_t end = 0;
  for (auto at = packed.bytes.begin(); at != packed.bytes.end();) {
    std::uint32_t voxel = end + takeNumber(at);
    const std::uint32_t length = takeNumber(at);
    end = voxel + length;
    for (; voxel < end; ++voxel) change.voxels.push_back(voxel);
  }
  return change;
}

MaskChange merged(MaskChange first, MaskChange second) {
  std::sort(first.voxels.begin(), first.voxels.end());
  std::sort(second.voxels.begin(), second.voxels.end());
  MaskChange both;
  std::set_symmetric_difference(first.voxels.begin(), first.voxels.end(), second.voxels.begin(),
                                second.voxels.end(), std::back_inserter(both.voxels));
  return both;
}

void flip(volume::Mask& mask, const MaskChange& change) {
  for (const std::uint32_t voxel : change.voxels) mask.voxels[voxel] ^= 1;
}

MaskChange difference(const volume::Mask& from, const volume::Mask& to) {
  if (!from.grid.matches(to.grid))
    throw Error("the masks lie on different grids", {}, "resample one of them");
  MaskChange change;
  for (std::size_t v = 0; v < from.voxels.size(); ++v)
    if ((from.voxels[v] != 0) != (to.voxels[v] != 0)) change.voxels.push_back(std::uint32_t(v));
  return change;
}

}  // namespace facenav::editing
