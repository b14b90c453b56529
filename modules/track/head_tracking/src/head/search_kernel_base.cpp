#include "facenav/core/simd.h"
#include "search_kernel_loops.h"

namespace facenav::head_tracking::search {

const Kernel& baseKernel() { return kLoops; }

const Kernel& kernel() {
  static const Kernel& chosen = chooseKernel(baseKernel, avx2Kernel);
  return chosen;
}

}  // namespace facenav::head_tracking::search
