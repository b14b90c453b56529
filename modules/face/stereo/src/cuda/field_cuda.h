#pragma once
// The "field" matcher's kernels on an NVIDIA GPU (CMake option FACENAV_CUDA). They replace those of
// block_kernel.h and plane_kernel.h and use the same memory, which is copied to the device and back at each
// call.

#include "kernels/block_kernel.h"
#include "kernels/plane_kernel.h"

namespace facenav::stereo::cuda {

/// True if a CUDA device is available.
bool hasDevice();

/// Throw std::runtime_error with the device's message on failure. All rows are done in one strip.
block::Kernel blockKernel(const block::Kernel& on_processor);
planes::Kernel planeKernel(const planes::Kernel& on_processor);

}  // namespace facenav::stereo::cuda
