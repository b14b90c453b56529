#include "convolution_kernel.h"

#include "facenav/core/simd.h"

namespace facenav::segmentation::convolution {
namespace {
#include "convolution_kernel.inl"
}  // namespace

Kernel baseKernel() { return {convolve}; }

const Kernel& kernel() {
  static const Kernel chosen = chooseKernel(baseKernel, avx2Kernel);
  return chosen;
}

}  // namespace facenav::segmentation::convolution
