#include "resample_kernel.h"

namespace facenav::stereo::resample {
namespace {
#include "resample_kernel.inl"
}  // namespace

Kernel avx2Kernel() { return {filterColumns, resampleRow}; }

}  // namespace facenav::stereo::resample
