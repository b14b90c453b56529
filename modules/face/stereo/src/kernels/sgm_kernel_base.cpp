#include "sgm_kernel.h"

#include "facenav/core/simd.h"

namespace facenav::stereo::sgm {
namespace {
#include "sgm_kernel.inl"
}  // namespace

Kernel baseKernel() { return {step, distances}; }

const Kernel& kernel() {
  static const Kernel chosen = chooseKernel(baseKernel, avx2Kernel);
  return chosen;
}

}  // namespace facenav::stereo::sgm
