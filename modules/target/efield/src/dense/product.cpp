#include "dense/product.h"

#include <algorithm>
#include <vector>

#include "facenav/core/error.h"
#include "facenav/core/parallel_for.h"
#include "kernels/field_kernel.h"

namespace facenav::efield::dense {
namespace {

using kernels::kTileColumns;
using kernels::kTileRows;
using Index = std::ptrdiff_t;

// A block of `a` (kRowBlock x kDepth floats, 288 KB) stays in a core's second-level cache.
constexpr Index kDepth = 384, kRowBlock = 12 * kTileRows;
constexpr double kWorthSharing = 2e6;  // multiplications; below it threads cost more than they save

Index upTo(Index count, Index step) { return (count + step - 1) / step; }

/// Copies columns into groups of kTileColumns, row by row, times `factor`; missing columns become 0.
void packColumns(const MatrixView& b, float factor, Index group, float* to) {
  const Index first = group * kTileColumns, count = std::min<Index>(kTileColumns, b.columns - first);
  for (Index k = 0; k < b.rows; ++k, to += kTileColumns) {
    for (Index j = 0; j < count; ++j) to[j] = factor * b(k, first + j);
    std::fill(to + count, to + kTileColumns, 0.f);
  }
}

/// Copies rows into groups of kTileRows, column by column; missing rows become 0.
void packRows(const MatrixView& a, float* to) {
  for (Index first = 0; first < a.rows; first += kTileRows, to += kTileRows * a.columns) {
    const Index count = std::min<Index>(kTileRows, a.rows - first);
    if (a.row_step == 1) {
      for (Index k = 0; k < a.columns; ++k) {
        std::copy_n(&a(first, k), count, to + k * kTileRows);
        std::fill(to + k * kTileRows + count, to + (k + 1) * kTileRows, 0.f);
      }
      continue;
    }
    for (Index i = 0; i < kTileRows; ++i)
      for (Index k = 0; k < a.columns; ++k) to[k * kTileRows + i] = i < count ? a(first + i, k) : 0.f;
  }
}

/// Adds the product of one block of rows with all packed columns.
void addBlock(const MatrixView& c, const MatrixView& a, const std::vector<float>& packed_b, float* packed_a) {
  packRows(a, packed_a);
  const kernels::Kernel& kernel = kernels::kernel();
  for (Index j = 0; j < c.columns; j += kTileColumns)
    for (Index i = 0; i < c.rows; i += kTileRows)
      kernel.tile({a.columns, packed_a + i * a.columns, packed_b.data() + j * a.columns, &c(i, j),
                   c.column_step, int(std::min<Index>(kTileRows, c.rows - i)),
                   int(std::min<Index>(kTileColumns, c.columns - j))});
}

}  // namespace

void addProduct(const MatrixView& c, float factor, const MatrixView& a, const MatrixView& b) {
  FACENAV_EXPECT(c.row_step == 1 && c.rows == a.rows && c.columns == b.columns && a.columns == b.rows,
                 "matrices that fit");
  if (c.rows == 0 || c.columns == 0) return;
  const bool is_shared = double(c.rows) * double(c.columns) * double(a.columns) > kWorthSharing;
  const std::size_t cores = is_shared ? coreCount() : 1;
  const Index groups = upTo(c.columns, kTileColumns);
  // Small blocks where there are few rows, so that every core gets some.
  const Index fair = upTo(upTo(c.rows, Index(2 * cores)), kTileRows) * kTileRows;
  const Index block = std::min(kRowBlock, is_shared ? fair : kRowBlock);
  std::vector<float> packed_b(std::size_t(groups * kTileColumns * std::min(kDepth, a.columns)));
  std::vector<std::vector<float>> packed_a(cores);
  for (Index k = 0; k < a.columns; k += kDepth) {
    const Index depth = std::min(kDepth, a.columns - k);
    parallelFor(std::size_t(groups), cores, [&](std::size_t group, std::size_t) {
      packColumns(b.part(k, 0, depth, b.columns), factor, Index(group),
                  packed_b.data() + Index(group) * kTileColumns * depth);
    });
    parallelFor(std::size_t(upTo(c.rows, block)), cores, [&](std::size_t item, std::size_t worker) {
      packed_a[worker].resize(std::size_t(kRowBlock * kDepth));
      const Index first = Index(item) * block, count = std::min(block, c.rows - first);
      addBlock(c.part(first, 0, count, c.columns), a.part(first, k, count, depth), packed_b,
               packed_a[worker].data());
    });
  }
}

}  // namespace facenav::efield::dense
