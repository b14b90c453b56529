#include "subpixel_kernel.h"

#include <cmath>

namespace facenav::stereo::subpixel {
namespace {
#include "subpixel_kernel.inl"
}  // namespace

Kernel avx2Kernel() { return {fitRow, fitAt, refineRow}; }

}  // namespace facenav::stereo::subpixel
