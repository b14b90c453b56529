#include "search_kernel_loops.h"

namespace facenav::head_tracking::search {

const Kernel& avx2Kernel() { return kLoops; }

}  // namespace facenav::head_tracking::search
