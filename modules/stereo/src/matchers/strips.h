#pragma once
// Into how many strips of rows work is cut: each strip repeats some rows of its neighbours, so no more than
// threads can use. The results must not depend on it.

#include <algorithm>

#include "facenav/core/parallel_for.h"

namespace facenav::stereo {

inline int stripsFor(int rows) {
  const int threads = int(coreCount());
  return std::clamp(threads == 1 ? 1 : 2 * threads, 1, std::max(rows / 4, 1));
}

}  // namespace facenav::stereo
