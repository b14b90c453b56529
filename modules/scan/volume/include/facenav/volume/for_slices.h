#pragma once
// Runs work on all cores, one slice of a grid at a time. Two calls must not write to the same place. The
// result does not depend on how slices are distributed.

#include "facenav/core/parallel_for.h"

namespace facenav::volume {

/// Calls work(k) for k = 0 .. count - 1, on all cores. Neighbouring slices are done in blocks, so that voxels
/// shared by two slices are read once.
template <class Work>
void forSlices(int count, Work&& work) {
  parallelRanges(0, count, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) work(k);
  });
}

}  // namespace facenav::volume
