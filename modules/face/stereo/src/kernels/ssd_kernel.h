#pragma once
// The whole-pixel search of the "ssd" matcher over one strip of rows: plain loops over 16-bit integers that
// the compiler turns into SIMD. Each pixel's disparities lie side by side in memory. Compiled twice
// (facenav/core/simd.h).

#include <cstdint>

namespace facenav::stereo::ssd {

constexpr int kDisparityBlock = 16;     // disparities are padded to a multiple of this
constexpr int kLargestDifference = 23;  // 23 * 23 * 121 < 2^16: the truncated sum fits 16 bits at 11 x 11
constexpr std::uint16_t kNoCost = 65535;

struct Images {
  const std::uint8_t* left;  // normalised, row -half .. height + half are readable (padded by the caller)
  const std::uint8_t*
      right_mirrored;  // likewise, columns from right to left, so that disparities rise in memory
  int left_stride, right_stride;
  int width, height;
  int disparities;  // padded
  int half;         // of the window
};

struct Scratch {
  std::uint16_t* column;       // (width + 2 * half) * disparities
  std::uint16_t* box;          // disparities
  std::uint16_t* right_cost;   // width + disparities
  std::uint16_t* right_match;  // width + disparities
  const std::uint16_t* zeros;  // kDisparityBlock of them
};

struct Kernel {
  /// Rows [first, last): the best disparity of each pixel; -1 where there is none that the right image agrees
  /// with. `uniqueness`: the second best cost must exceed the best by this share / 256.
  void (*search_rows)(const Images& images, const Scratch& scratch, int first, int last, int uniqueness,
                      std::int16_t* disparity, int disparity_stride);
};

Kernel baseKernel();
Kernel avx2Kernel();
/// The fastest that this processor runs.
const Kernel& kernel();

}  // namespace facenav::stereo::ssd
