#include "field_kernel.h"

#include <cmath>

namespace facenav::stereo::field {
namespace {
#include "field_kernel.inl"
}  // namespace

Kernel avx2Kernel() { return {step, pixelRow}; }

}  // namespace facenav::stereo::field
