#include "field_kernel.h"

#include <cmath>

namespace facenav::stereo::field {
namespace {
#include "field_kernel.inl"
}  // namespace

Kernel baseKernel() { return {step, pixelRow}; }

}  // namespace facenav::stereo::field
