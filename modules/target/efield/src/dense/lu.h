#pragma once
// LU factorisation with row pivoting of a large float matrix, in place, on all cores. Recursive in the
// columns (Toledo 1997, SIAM J. Matrix Anal. Appl. 18:1065): nearly all of it is matrix products.

#include <functional>
#include <vector>

#include "dense/matrix_view.h"

namespace facenav::efield::dense {

/// Rows exchanged with row i at step i.
using Pivots = std::vector<int>;

/// Called with the share of the work that is done, 0 .. 1; what it throws ends the work.
using WorkDone = std::function<void(double share)>;

/// Factorises the square matrix `a` (row_step 1) in place. Throws Error for a singular matrix.
Pivots factorise(const MatrixView& a, const WorkDone& report = {});
/// Solves A x = b in place, for all columns of `b` (row_step 1), with the result of factorise().
void solve(const MatrixView& lu, const Pivots& pivots, const MatrixView& b);
/// Solves A^T x = b in place.
void solveTransposed(const MatrixView& lu, const Pivots& pivots, const MatrixView& b);

}  // namespace facenav::efield::dense
