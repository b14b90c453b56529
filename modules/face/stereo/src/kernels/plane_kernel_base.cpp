#include "plane_kernel.h"

#include <cmath>

#include "facenav/core/simd.h"

namespace facenav::stereo::planes {
namespace {
#include "plane_kernel.inl"
}  // namespace

Kernel baseKernel() { return {step, pixelRow, mapRow, splineRow}; }

const Kernel& kernel() {
  static const Kernel chosen = chooseKernel(baseKernel, avx2Kernel);
  return chosen;
}

}  // namespace facenav::stereo::planes
