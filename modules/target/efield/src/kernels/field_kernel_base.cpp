#include "field_kernel.h"

#include "facenav/core/simd.h"

namespace facenav::efield::kernels {
namespace {
#include "field_kernel.inl"
}  // namespace

Kernel baseKernel() { return allOf(); }

const Kernel& kernel() {
  static const Kernel chosen = chooseKernel(baseKernel, avx2Kernel);
  return chosen;
}

}  // namespace facenav::efield::kernels
