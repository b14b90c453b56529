#include "search_kernel_loops.h"

namespace facenav::head_tracking::search {

const Kernel& baseKernel() { return kLoops; }

const Kernel& kernel() {
#if defined(FACENAV_HAS_AVX2) && (defined(__x86_64__) || defined(__i386__))
  static const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return has_avx2 ? avx2Kernel() : baseKernel();
#else
  return baseKernel();
#endif
}

}  // namespace facenav::head_tracking::search
