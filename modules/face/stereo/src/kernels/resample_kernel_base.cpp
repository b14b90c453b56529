#include "resample_kernel.h"

#include "facenav/core/simd.h"

namespace facenav::stereo::resample {
namespace {
#include "resample_kernel.inl"
}  // namespace

Kernel baseKernel() { return {filterColumns, resampleRow}; }

const Kernel& kernel() {
  static const Kernel chosen = chooseKernel(baseKernel, avx2Kernel);
  return chosen;
}

}  // namespace facenav::stereo::resample
