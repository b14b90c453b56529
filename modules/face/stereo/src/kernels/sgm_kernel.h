#pragma once
// Inner loops of the "sgm" matcher (semi-global matching, Hirschmueller 2008, on census costs, Zabih and
// Woodfill 1994). Compiled twice (facenav/core/simd.h).

#include <cstdint>

namespace facenav::stereo::sgm {

constexpr int kPadding = 16;          // of a path's costs, before and after the disparities
constexpr std::int16_t kFar = 16384;  // costs there

/// Path costs of one pixel, from those of the one before: adds them to `total`; returns the least. `before`
/// and `now` are readable kPadding elements beyond both ends and hold kFar there. `cost`: census distances.
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
/// The fastest that this processor runs.
const Kernel& kernel();

}  // namespace facenav::stereo::sgm
