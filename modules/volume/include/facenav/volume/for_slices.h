#pragma once
// Work on all cores, a slice of a grid at a time. The parts must not write to the same place; the result does
// not depend on how they are shared out.

#include <algorithm>

#include "facenav/core/parallel_for.h"

namespace facenav::volume {

/// Calls work(k) for k = 0 .. count - 1, on all cores: neighbouring slices in blocks, whose rims are read
/// twice otherwise.
template <class Work>
void forSlices(int count, Work&& work) {
  constexpr int kBlocksACore = 4;  // so that none waits long for the last one
  const int cores = int(coreCount()), blocks = std::clamp(kBlocksACore * cores, 1, std::max(1, count));
  parallelFor(std::size_t(blocks), std::size_t(cores), [&](std::size_t block, std::size_t) {
    const int end = int((block + 1) * std::size_t(count) / std::size_t(blocks));
    for (int k = int(block * std::size_t(count) / std::size_t(blocks)); k < end; ++k) work(k);
  });
}

}  // namespace facenav::volume
