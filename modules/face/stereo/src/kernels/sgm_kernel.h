#pragma once
// Inner loops of the "sgm" matcher (semi-global matching, Hirschmueller 2008, on census costs, Zabih and
// Woodfill 1994). Compiled twice (facenav/core/simd.h).

#include <cstdint>

namespace facenav::stereo::sgm {

constexpr int kPadding = 16;          // elements before and after a path's costs
constexpr std::int16_t kFar = 16384;  // cost in the padding

/// Path costs of one pixel from those of the pixel before. Adds them to `total` and returns the least.
/// `before` and `now` are readable kPadding elements beyond both ends and contain kFar there. `cost`: census
/// distances.
using Step = std::int16_t (*)(const std::uint8_t* cost, const std::int16_t* before, std::int16_t least_before,
                              std::int16_t small_step, std::int16_t large_step, int disparities,
                              std::int16_t* now, std::int16_t* total);

/// Census distances of one left word to `count` right words, each left of the one before.
using Distances = void (*)(std::uint64_t left, const std::uint64_t* right, int count, std::uint8_t* out);

struct Kernel {
  Step step;
  Distances distances;
};

Kernel baseKernel();
Kernel avx2Kernel();
/// Returns the fastest version for this processor.
const Kernel& kernel();

}  // namespace facenav::stereo::sgm
