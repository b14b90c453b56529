#include "block_kernel.h"

#include "facenav/core/simd.h"

namespace facenav::stereo::block {
namespace {
#include "block_kernel.inl"
}  // namespace

Kernel baseKernel() { return {search, levels, cellSums}; }

const Kernel& kernel() {
  static const Kernel chosen = chooseKernel(baseKernel, avx2Kernel);
  return chosen;
}

}  // namespace facenav::stereo::block
