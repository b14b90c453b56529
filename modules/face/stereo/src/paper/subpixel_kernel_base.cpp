#include "subpixel_kernel.h"

#include <cmath>

#include "facenav/core/simd.h"

namespace facenav::stereo::subpixel {
namespace {
#include "subpixel_kernel.inl"
}  // namespace

Kernel baseKernel() { return {fitRow, fitAt, refineRow}; }

const Kernel& kernel() {
  static const Kernel chosen = chooseKernel(baseKernel, avx2Kernel);
  return chosen;
}

}  // namespace facenav::stereo::subpixel
