#pragma once
// Work on all cores, a slice of a grid at a time. The parts must not write to the same place; the result does
// not depend on how they are shared out.

#include "facenav/core/parallel_for.h"

namespace facenav::volume {

/// Calls work(k) for k = 0 .. count - 1, on all cores: neighbouring slices in blocks, whose rims are read
/// twice otherwise.
template <class Work>
void forSlices(int count, Work&& work) {
  parallelRanges(0, count, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) work(k);
  });
}

}  // namespace facenav::volume
