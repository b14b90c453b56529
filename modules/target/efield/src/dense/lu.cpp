#include "dense/lu.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dense/product.h"
#include "facenav/core/error.h"
#include "facenav/core/parallel_for.h"

namespace facenav::efield::dense {
namespace {

using Index = std::ptrdiff_t;
constexpr Index kSmall = 16;    // columns that are worked on one by one
constexpr Index kPanel = 1024;  // columns that are worked on between two reports

/// Splits a size near its middle, at a multiple of kSmall.
Index firstHalf(Index size) { return (size / 2 + kSmall - 1) / kSmall * kSmall; }

/// Exchanges rows `first` .. in all columns of `b`: row i with row pivots[i], forwards or backwards.
void exchangeRows(const MatrixView& b, const int* pivots, Index count, bool is_forward = true) {
  if (b.columns <= 0) return;
  const auto inRange = [&](int begin, int end) {
    for (int j = begin; j < end; ++j)
      for (Index s = 0; s < count; ++s) {
        const Index i = is_forward ? s : count - 1 - s;
        if (pivots[i] != i) std::swap(b(i, j), b(pivots[i], j));
      }
  };
  if (b.columns * count < 20000)
    inRange(0, int(b.columns));
  else
    parallelRanges(0, int(b.columns), inRange);
}

/// Solves L x = b in place, `lower` with its own or with a unit diagonal.
void solveLower(const MatrixView& lower, bool is_unit, const MatrixView& b) {
  const Index n = lower.rows;
  if (n > kSmall) {
    const Index n1 = firstHalf(n), n2 = n - n1;
    const MatrixView top = b.part(0, 0, n1, b.columns), bottom = b.part(n1, 0, n2, b.columns);
    solveLower(lower.part(0, 0, n1, n1), is_unit, top);
    addProduct(bottom, -1.f, lower.part(n1, 0, n2, n1), top);
    return solveLower(lower.part(n1, n1, n2, n2), is_unit, bottom);
  }
  for (Index j = 0; j < b.columns; ++j)
    for (Index i = 0; i < n; ++i) {
      float value = b(i, j);
      for (Index k = 0; k < i; ++k) value -= lower(i, k) * b(k, j);
      b(i, j) = is_unit ? value : value / lower(i, i);
    }
}

/// Solves U x = b in place.
void solveUpper(const MatrixView& upper, bool is_unit, const MatrixView& b) {
  const Index n = upper.rows;
  if (n > kSmall) {
    const Index n1 = firstHalf(n), n2 = n - n1;
    const MatrixView top = b.part(0, 0, n1, b.columns), bottom = b.part(n1, 0, n2, b.columns);
    solveUpper(upper.part(n1, n1, n2, n2), is_unit, bottom);
    addProduct(top, -1.f, upper.part(0, n1, n1, n2), bottom);
    return solveUpper(upper.part(0, 0, n1, n1), is_unit, top);
  }
  for (Index j = 0; j < b.columns; ++j)
    for (Index i = n - 1; i >= 0; --i) {
      float value = b(i, j);
      for (Index k = i + 1; k < n; ++k) value -= upper(i, k) * b(k, j);
      b(i, j) = is_unit ? value : value / upper(i, i);
    }
}

/// Factorises a few columns, one by one.
void factoriseColumns(const MatrixView& a, int* pivots) {
  for (Index k = 0; k < a.columns; ++k) {
    Index best = k;
    for (Index i = k + 1; i < a.rows; ++i)
      if (std::abs(a(i, k)) > std::abs(a(best, k))) best = i;
    if (!(std::abs(a(best, k)) > 0)) throw Error("the equations of the head model have no unique solution");
    pivots[k] = int(best);
    if (best != k)
      for (Index j = 0; j < a.columns; ++j) std::swap(a(k, j), a(best, j));
    const float inverse = 1.f / a(k, k);
    for (Index i = k + 1; i < a.rows; ++i) a(i, k) *= inverse;
    for (Index j = k + 1; j < a.columns; ++j) {
      const float factor = a(k, j);
      for (Index i = k + 1; i < a.rows; ++i) a(i, j) -= factor * a(i, k);
    }
  }
}

/// Counts multiplications and reports their share after each large step.
class Work {
 public:
  Work(double all, const WorkDone& report) : all_(all), report_(report) {}
  void add(Index rows, Index depth, Index columns) {
    done_ += double(rows) * double(depth) * double(columns);
    if (report_ && done_ - reported_ > all_ / 100) report_(std::min(1.0, (reported_ = done_) / all_));
  }

 private:
  double all_, done_ = 0, reported_ = 0;
  const WorkDone& report_;
};

/// Factorises a tall matrix. Pivots count from its first row.
void factoriseTall(const MatrixView& a, int* pivots, Work& work) {
  if (a.columns <= kSmall) return factoriseColumns(a, pivots);
  const Index n1 = firstHalf(a.columns), n2 = a.columns - n1, below = a.rows - n1;
  const MatrixView left = a.part(0, 0, a.rows, n1), right = a.part(0, n1, a.rows, n2);
  factoriseTall(left, pivots, work);
  exchangeRows(right, pivots, n1);
  // Works in parts, so that progress is reported in between.
  for (Index first = 0; first < n2; first += kPanel) {
    const Index count = std::min(kPanel, n2 - first);
    const MatrixView top = right.part(0, first, n1, count);
    solveLower(left.part(0, 0, n1, n1), true, top);
    addProduct(right.part(n1, first, below, count), -1.f, left.part(n1, 0, below, n1), top);
    work.add(below + n1 / 2, n1, count);
  }
  factoriseTall(right.part(n1, 0, below, n2), pivots + n1, work);
  exchangeRows(left.part(n1, 0, below, n1), pivots + n1, n2);
  for (Index i = n1; i < a.columns; ++i) pivots[i] += int(n1);
}

}  // namespace

Pivots factorise(const MatrixView& a, const WorkDone& report) {
  FACENAV_EXPECT(a.rows == a.columns && a.row_step == 1, "a square matrix");
  Pivots pivots(std::size_t(a.rows));
  Work work(std::pow(double(a.rows), 3) / 3, report);
  factoriseTall(a, pivots.data(), work);
  return pivots;
}

void solve(const MatrixView& lu, const Pivots& pivots, const MatrixView& b) {
  exchangeRows(b, pivots.data(), Index(pivots.size()));
  solveLower(lu, true, b);
  solveUpper(lu, false, b);
}

void solveTransposed(const MatrixView& lu, const Pivots& pivots, const MatrixView& b) {
  solveLower(lu.transposed(), false, b);
  solveUpper(lu.transposed(), true, b);
  exchangeRows(b, pivots.data(), Index(pivots.size()), false);
}

}  // namespace facenav::efield::dense
