#pragma once
// The "field" matcher's kernels on an NVIDIA GPU (CMake option FACENAV_CUDA): stand-ins for those of
// block_kernel.h and plane_kernel.h, on the same memory, which goes to the device and back at each call.

#include "kernels/block_kernel.h"
#include "kernels/plane_kernel.h"

namespace facenav::stereo::cuda {

/// True where a device answers.
bool hasDevice();

/// Throw std::runtime_error with the device's own words when it fails. Rows are done in one strip.
block::Kernel blockKernel(const block::Kernel& on_processor);
planes::Kernel planeKernel(const planes::Kernel& on_processor);

}  // namespace facenav::stereo::cuda
