#pragma once
// Product of large float matrices, on all cores, with the instruction set of this processor. Eigen's product
// would use SSE2 alone, since the program is built for every 64-bit processor: a quarter of the speed.

#include "dense/matrix_view.h"

namespace facenav::efield::dense {

/// Adds factor * a * b to c. The rows of `c` are contiguous (row_step 1); c must not overlap a or b.
void addProduct(const MatrixView& c, float factor, const MatrixView& a, const MatrixView& b);

}  // namespace facenav::efield::dense
