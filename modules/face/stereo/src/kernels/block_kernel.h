#pragma once
// The "field" matcher's start: whole-pixel disparities of 4 x 4 pixel blocks, with every disparity searched
// at full resolution. Truncated absolute differences of locally normalised images (6 bits) add up to 8 bits
// over a block, 32 disparities to an AVX2 register. Windows are 3 x 3 blocks (12 x 12 pixels), of which every
// other row is read (all rows take a quarter more time and find the same surfaces). Compiled twice
// (facenav/core/simd.h).

#include <cstdint>

namespace facenav::stereo::block {

constexpr int kBlock = 4;               // pixels along each side
constexpr int kDisparityBlock = 32;     // disparities are padded to a multiple of this
constexpr int kLargestDifference = 15;  // 16 * 15 < 2^8
constexpr int kRowStep = 2;             // every n-th row is read

struct Images {
  const std::uint8_t* left;  // normalised to 0 .. 63
  const std::uint8_t*
      right_mirrored;  // normalised too; columns from right to left, so that disparities rise in memory
  int left_stride, right_stride;
  int columns, rows;  // number of blocks
  int width;          // of the left image, px; right_mirrored's column of x at disparity d: width - 1 - x + d
  int disparities;    // number of disparities, padded
};

struct Kernel {
  /// Rows [first, last) of blocks: the best disparity with its fraction (parabola); -1 if the second best
  /// cost is not `uniqueness` / 256 above the best. `stride`: floats from row to row.
  void (*search)(const Images&, int first, int last, int uniqueness, std::uint8_t* scratch, float* disparity,
                 int stride);
  /// One row of normalised levels: (grey * scale + offset) limited to 0 .. highest; `invalid` outside the
  /// mask.
  void (*levels)(const float* grey, const std::uint8_t* mask, const float* scale, const float* offset,
                 int width, int highest, int invalid, std::uint8_t* out);
  /// Sums of grey levels and of their squares over the cells of 4 x 4 pixels in four rows. `width`: a
  /// multiple of 4. `columns`: 2 * width floats of scratch memory.
  void (*cell_sums)(const float* rows, int stride, int width, float* columns, float* sums, float* squares);
};

/// Bytes of scratch memory that `search` needs.
inline std::int64_t scratchSize(int columns, int disparities) {
  // Three rows of block sums (8 bits), one row of column sums (16 bits), one window and the numbers of the
  // disparities (16 bits).
  return std::int64_t(columns) * disparities * 5 + std::int64_t(disparities) * 4;
}

Kernel baseKernel();
Kernel avx2Kernel();
/// Returns the fastest version for this processor.
const Kernel& kernel();

}  // namespace facenav::stereo::block
