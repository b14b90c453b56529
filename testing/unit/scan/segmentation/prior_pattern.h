#pragma once
// The pattern that resources/training/brain_prior/expected.py passes to torch.

#include <cmath>

#include "prior/prior_network.h"

namespace facenav::segmentation {

inline volume::Volume pattern() {
  volume::Volume window;
  window.grid.size = kPriorSize;
  for (int k = 0; k < kPriorSize[2]; ++k)
    for (int j = 0; j < kPriorSize[1]; ++j)
      for (int i = 0; i < kPriorSize[0]; ++i)
        window.voxels.push_back(
            float(0.5 + 0.5 * std::sin(0.37 * i) * std::sin(0.23 * j + 1) * std::sin(0.31 * k + 2)));
  return window;
}

}  // namespace facenav::segmentation
