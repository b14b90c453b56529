#pragma once
// Stage 2 of the "ssd" matcher, one row: Gauss-Newton fit of the right window to the left one. The model is
//   left(x + u, y + v) = gain * right(x + u - (d + a u + b v), y + v) + offset
// with u, v over the window; d the disparity, a and b its slopes. Gain and offset are solved for exactly at
// each step (they enter linearly), then d, a, b by a 3 x 3 system. Compiled twice (facenav/core/simd.h).

#include <cstdint>

namespace facenav::stereo::subpixel {

constexpr int kLargestWindow = 11, kLanes = 12;  // a row of the window, padded for SIMD

struct Images {
  const float* left;
  const float* right_fine;  // kFineSteps samples per pixel along x
  const std::uint8_t *left_mask, *right_mask;
  int left_stride, right_stride, left_mask_stride, right_mask_stride;  // in elements
  int width, height, right_width;                                      // right_width in whole pixels
  int right_shift;  // column of the right image = x - disparity + right_shift
  int window;
};

struct Limits {
  float largest_sigma_px, least_correlation, largest_slope, largest_lever_px, least_centre_texture;
};

struct Plane {
  float d, a, b;  // disparity at the pixel, slopes along x and y
};

struct Fit {
  Plane plane;
  float sigma, correlation;
  bool is_good;
};

/// Result images, float, one stride (in elements) for all; disparity NaN without an accepted fit.
struct Field {
  float *disparity, *slope_x, *slope_y, *sigma;
  int stride;
};

/// The kernels of one instruction set.
struct Kernel {
  /// Fits every pixel of row y that has a start (whole-pixel disparity, -1: none). Neighbours pass on their
  /// planes.
  void (*fit_row)(const Images&, const Limits&, int y, const std::int16_t* start, const Field&);
  /// Fits one pixel from a plane carried over from a neighbour.
  Fit (*fit_at)(const Images&, const Limits&, int x, int y, Plane start);
  /// Fits row y again with the surface's shape inside the window, as given by `seen`, instead of a plane. A
  /// plane cuts off ridges and fills hollows.
  void (*refine_row)(const Images&, const Limits&, int y, const Field& seen, const Field& refined);
};

Kernel baseKernel();
Kernel avx2Kernel();
/// Returns the fastest version for this processor.
const Kernel& kernel();

}  // namespace facenav::stereo::subpixel
