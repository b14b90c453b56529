#include "field_kernel.h"

#include <cmath>

#include "facenav/core/simd.h"

namespace facenav::stereo::field {
namespace {
#include "field_kernel.inl"
}  // namespace

Kernel baseKernel() { return {step, pixelRow}; }

const Kernel& kernel() {
  static const Kernel chosen = chooseKernel(baseKernel, avx2Kernel);
  return chosen;
}

}  // namespace facenav::stereo::field
