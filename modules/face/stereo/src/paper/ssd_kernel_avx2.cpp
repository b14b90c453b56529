#include "ssd_kernel.h"

namespace facenav::stereo::ssd {
namespace {
#include "ssd_kernel.inl"
}  // namespace

Kernel avx2Kernel() { return {searchRows}; }

}  // namespace facenav::stereo::ssd
