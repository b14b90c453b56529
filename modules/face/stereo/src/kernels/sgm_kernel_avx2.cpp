#include "sgm_kernel.h"

namespace facenav::stereo::sgm {
namespace {
#include "sgm_kernel.inl"
}  // namespace

Kernel avx2Kernel() { return {step, distances}; }

}  // namespace facenav::stereo::sgm
