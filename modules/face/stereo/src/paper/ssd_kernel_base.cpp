#include "ssd_kernel.h"

#include "facenav/core/simd.h"

namespace facenav::stereo::ssd {
namespace {
#include "ssd_kernel.inl"
}  // namespace

Kernel baseKernel() { return {searchRows}; }

const Kernel& kernel() {
  static const Kernel chosen = chooseKernel(baseKernel, avx2Kernel);
  return chosen;
}

}  // namespace facenav::stereo::ssd
