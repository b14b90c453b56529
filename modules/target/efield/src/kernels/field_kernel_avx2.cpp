#include "field_kernel.h"

namespace facenav::efield::kernels {
namespace {
#include "field_kernel.inl"
}  // namespace

Kernel avx2Kernel() { return allOf(); }

}  // namespace facenav::efield::kernels
