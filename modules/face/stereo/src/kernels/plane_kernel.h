#pragma once
// The "field" matcher's inner loops, compiled twice (facenav/core/simd.h). All loops run along rows of plain
// arrays, so that the compiler can turn them into SIMD.
//
// The surface is a grid of planes, one at the middle of each 4 x 4 pixel block: disparity d, slopes a, b.
// Between the middles, neighbouring planes are blended. A Gauss-Newton step warps the right image once by the
// whole surface. Each pixel's grey value then gives an estimate of the disparity there: d - e / g with weight
// g^2, where e is the difference left - (offset + gain * right) and g the gain times the right image's
// gradient. Weighted least squares over a window gives the new planes. Windows are sums over 4 x 4 blocks,
// smoothed between blocks: they cost almost nothing, and follow the surface's own shape where it bends. Gain
// and offset come from the previous step.

#include <cstdint>

#include "image_rows.h"

namespace facenav::stereo::planes {

constexpr int kBlock = 4;
constexpr int kLargestRadius = 3;  // radius of the window, in blocks
constexpr int kSplineRadius = 6;
constexpr int kMoments = 10;     // sums of the plane fit: h, hu, huu, hv, huv, hvv, y, yu, yv, ee
constexpr int kPhotometric = 6;  // 1, right, left, right^2, left right, left^2
constexpr int kSums = kMoments + kPhotometric;

/// Planes of one stride, rows x columns, one value for each block.
struct Field {
  float *d, *a, *b;          // disparity at the block's middle (4 i + 1.5 px), slopes along x and y
  float *a_prior, *b_prior;  // prior of the slopes, from the neighbourhood
  float *offset, *gain;      // left = offset + gain * right
  float *sigma, *correlation;
  int columns, rows, stride;
};

struct Window {
  int radius;                         // radius in blocks
  float weights[kLargestRadius + 1];  // from the middle outwards; 1 in the middle
  float noise_factor;                 // sum of squared weights divided by the sum of weights
};

/// Floats of scratch memory for one strip.
inline std::int64_t scratchSize(int columns) {
  const std::int64_t padded = kBlock * std::int64_t(columns) + 64;
  return 24 * padded + std::int64_t(kSums) * (columns + 16) * (2 * kLargestRadius + 3);
}

struct Output {  // one pixel row; disparity NaN where the plane is not accepted
  float *disparity, *slope_x, *slope_y, *sigma;
};

struct Kernel {
  /// Block rows [first, last): a Gauss-Newton step from `from` to `to`; without `is_fit` only gain and
  /// offset.
  void (*step)(const ImageRows&, const Field& from, const Window&, bool is_fit, int first, int last,
               float* scratch, const Field& to);
  /// Disparity and slope along x of pixel row y (width rounded up to blocks).
  void (*pixel_row)(const Field&, int y, float* scratch, float* disparity);
  /// Pixel row y of the result; `disparity` from pixel_row. Accepted in columns [first, end) where the
  /// block's `accepted` is not NaN.
  void (*map_row)(const Field&, const float* accepted, int y, int first, int end, int width,
                  const float* disparity, const Output&);
  /// Symmetric filter of a row, kSplineRadius elements readable beyond both ends, kMiddle_grey subtracted.
  void (*spline_row)(const float* row, const float* weights, int width, float* out);
};

Kernel baseKernel();
Kernel avx2Kernel();
/// Returns the fastest version for this processor.
const Kernel& kernel();

}  // namespace facenav::stereo::planes
