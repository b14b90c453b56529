#pragma once
// The "field" matcher's inner loops, compiled twice (facenav/core/simd.h). All loops run along rows of plain
// arrays, so that the compiler can turn them into SIMD.
//
// Disparities are stored at nodes, one for each 2 x 2 pixels (node i lies at pixel 2 i + 0.5). One
// Gauss-Newton
// step over the whole image: warp the right row by the interpolated field, form the ten products of
//   left = offset + gain * right_warped + slope * gradient
// at each pixel, add them up over 2 x 2 pixels, smooth those sums with a Gaussian (the window), and solve
// the 3 unknowns at each node: d += -slope / gain. A window costs no more than smoothing. The field itself is
// the surface's shape inside each window, so slopes and curvature need no unknowns.

#include <cstdint>

#include "image_rows.h"

namespace facenav::stereo::field {

constexpr int kChannels = 10;      // products summed over the window
constexpr int kLargestRadius = 8;  // radius of the window, in nodes
constexpr float kJump_px =
    2.5f;  // nodes that differ by more belong to different surfaces and are not interpolated

struct Nodes {  // planes of one stride, rows x columns
  int columns, rows, stride;
};

struct Window {
  int radius;                         // radius in nodes
  float weights[kLargestRadius + 1];  // from the middle outwards; the sum over both sides is 1
  float independent;                  // number of independent pixels in a window: 1 / sum of squared weights
};

struct Step {  // result of one Gauss-Newton step, in planes like the field
  float *change, *sigma, *correlation;
};

struct Kernel {
  /// Gauss-Newton step for node rows [first, last).
  void (*step)(const ImageRows&, const Nodes&, const float* field, const Window&, int first, int last,
               float* scratch, const Step&);
  /// Field at the pixels of row y: bilinear between nodes of one surface.
  void (*pixel_row)(const Nodes&, const float* field, int y, int width, float* scratch, float* row);
};

/// Floats of scratch memory that `step` needs.
inline std::int64_t scratchSize(int columns) {
  const std::int64_t padded = 2 * columns + 2 * kLargestRadius;
  return padded * (14 + 2 * kChannels) + (2 * kLargestRadius + 3) * std::int64_t(kChannels) * padded;
}

Kernel baseKernel();
Kernel avx2Kernel();
/// Returns the fastest version for this processor.
const Kernel& kernel();

}  // namespace facenav::stereo::field
