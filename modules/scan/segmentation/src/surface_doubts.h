#pragma once
// Places of a mask's surface at which its doubt is stated: every other voxel.

#include <utility>
#include <vector>

#include "facenav/segmentation/segmenter.h"
#include "facenav/volume/mask_morphology.h"

namespace facenav::segmentation {

constexpr int kDoubtStep = 2;  // voxels between the places

/// Calls `doubt_at(v)` (mm) for the voxels of the surface where doubt is stated.
template <class DoubtAt>
std::vector<BoundaryDoubt> doubtsOver(const volume::Mask& mask, DoubtAt&& doubt_at) {
  const volume::Mask surface = volume::surfaceVoxels(mask);
  std::vector<BoundaryDoubt> doubts;
  std::size_t v = 0;
  for (int k = 0; k < surface.grid.size[2]; ++k)
    for (int j = 0; j < surface.grid.size[1]; ++j)
      for (int i = 0; i < surface.grid.size[0]; ++i, ++v)
        if (surface.voxels[v] && (i + j + k) % kDoubtStep == 0)
          doubts.push_back({surface.grid.toMri({double(i), double(j), double(k)}), doubt_at(v)});
  return doubts;
}

}  // namespace facenav::segmentation
