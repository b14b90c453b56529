#pragma once
// The whole-pixel search of the "ssd" matcher over one strip of rows: plain loops over 16-bit integers that
// the compiler turns into SIMD. Each pixel's disparities are contiguous in memory. Compiled twice
// (facenav/core/simd.h).

#include <cstdint>

namespace facenav::stereo::ssd {

constexpr int kDisparityBlock = 16;     // disparities are padded to a multiple of this
constexpr int kLargestDifference = 23;  // 23 * 23 * 121 < 2^16: the truncated sum fits 16 bits at 11 x 11
constexpr std::uint16_t kNoCost = 65535;

struct Images {
  const std::uint8_t* left;  // normalised; rows -half .. height + half are readable (padded by the caller)
  const std::uint8_t*
      right_mirrored;  // normalised too; columns from right to left, so that disparities rise in memory
  int left_stride, right_stride;
  int width, height;
  int disparities;  // number of disparities, padded
  int half;         // half side of the window
};

struct Scratch {
  std::uint16_t* column;       // size: (width + 2 * half) * disparities
  std::uint16_t* box;          // size: disparities
  std::uint16_t* right_cost;   // size: width + disparities
  std::uint16_t* right_match;  // size: width + disparities
  const std::uint16_t* zeros;  // size: kDisparityBlock
};

struct Kernel {
  /// Rows [first, last): the best disparity of each pixel; -1 if the right image does not agree.
  /// `uniqueness`: the second best cost must exceed the best by this share / 256.
  void (*search_rows)(const Images& images, const Scratch& scratch, int first, int last, int uniqueness,
                      std::int16_t* disparity, int disparity_stride);
};

Kernel baseKernel();
Kernel avx2Kernel();
/// Returns the fastest version for this processor.
const Kernel& kernel();

}  // namespace facenav::stereo::ssd
