#include "block_kernel.h"

namespace facenav::stereo::block {
namespace {
#include "block_kernel.inl"
}  // namespace

Kernel avx2Kernel() { return {search, levels, cellSums}; }

}  // namespace facenav::stereo::block
