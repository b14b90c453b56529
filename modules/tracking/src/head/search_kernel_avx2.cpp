#include "search_kernel_loops.h"

namespace facenav::tracking::search {

const Kernel& avx2Kernel() { return kLoops; }

}  // namespace facenav::tracking::search
