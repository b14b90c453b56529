#include "plane_kernel.h"

#include <cmath>

namespace facenav::stereo::planes {
namespace {
#include "plane_kernel.inl"
}  // namespace

Kernel avx2Kernel() { return {step, pixelRow, mapRow, splineRow}; }

}  // namespace facenav::stereo::planes
