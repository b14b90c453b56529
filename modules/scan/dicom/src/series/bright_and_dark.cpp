#include "bright_and_dark.h"

#include <algorithm>
#include <vector>

#include "facenav/core/robust_statistics.h"

namespace facenav::dicom {

bool isStoredInverted(const SliceHeader& header) {
  return header.modality == "MR" && header.voxels.photometric == "MONOCHROME1";
}

void darkenAir(volume::Volume& volume) {
  constexpr int kShare = 10;  // of each edge: the size of a corner
  const auto& size = volume.grid.size;
  const auto isAtEnd = [&](int i, int axis) {
    const int margin = std::max(1, size[std::size_t(axis)] / kShare);
    return i < margin || i >= size[std::size_t(axis)] - margin;
  };
  std::vector<float> corners;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        if (isAtEnd(i, 0) && isAtEnd(j, 1) && isAtEnd(k, 2)) corners.push_back(volume.at(i, j, k));
  const auto [low, high] = std::minmax_element(volume.voxels.begin(), volume.voxels.end());
  const float bottom = *low, top = *high;
  if (upperMedian(std::move(corners)) < 0.5f * (bottom + top)) return;
  for (float& value : volume.voxels) value = top - value;
}

}  // namespace facenav::dicom
