#pragma once
// Number of strips of rows that the work is divided into. Each strip repeats some rows of its neighbours, so
// there are no more strips than threads. The results must not depend on the number.

#include <algorithm>

#include "facenav/core/parallel_for.h"

namespace facenav::stereo {

inline int stripsFor(int rows) {
  const int threads = int(coreCount());
  return std::clamp(threads == 1 ? 1 : 2 * threads, 1, std::max(rows / 4, 1));
}

}  // namespace facenav::stereo
