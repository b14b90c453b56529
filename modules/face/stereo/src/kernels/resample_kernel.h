#pragma once
// Resamples images by quintic B-splines (Unser 1999; poles from his table). Cubic convolution blurs dots of
// one or two pixels too much to match them. Compiled twice (facenav/core/simd.h).

#include <cstdint>

namespace facenav::stereo::resample {

constexpr int kTaps = 6, kLanes = 8;  // weights are padded to SIMD width with zeros
constexpr int kSteps = 1024;          // steps per pixel in the table of weights
constexpr int kBorder = 4;            // readable coefficients beyond each side of the image

struct Kernel {
  /// Recursive filter of one pole down and up all columns, in place (mirrored at both ends).
  void (*filter_columns)(float* image, int stride, int width, int height, float pole);
  /// out[i] = image at (places[2 i], places[2 i + 1]); 0 more than a pixel outside. `coefficients` points at
  /// pixel (0, 0). `table`: (kSteps + 1) * kLanes weights.
  void (*row)(const float* coefficients, int stride, int width, int height, const float* table,
              const float* places, int count, float* out);
};

Kernel baseKernel();
Kernel avx2Kernel();
/// Returns the fastest version for this processor.
const Kernel& kernel();

}  // namespace facenav::stereo::resample
