#include "convolution_kernel.h"

namespace facenav::segmentation::convolution {
namespace {
#include "convolution_kernel.inl"
}  // namespace

Kernel avx2Kernel() { return {convolve}; }

}  // namespace facenav::segmentation::convolution
