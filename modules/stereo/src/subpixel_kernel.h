#pragma once
// Stage 2 of the "ssd" matcher, one row: Gauss-Newton fit of the right window to the left one. The model is
//   left(x + u, y + v) = gain * right(x + u - (d + a u + b v), y + v) + offset
// with u, v over the window; d the disparity, a and b its slopes. Gain and offset are solved for exactly at
// each step (they enter linearly), then d, a, b by a 3 x 3 system. Compiled twice, as ssd_kernel.h says.

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
  float largest_sigma_px, least_correlation, largest_slope;
};

struct Row {
  const std::int16_t* start;                     // whole-pixel disparity, -1: none
  float *disparity, *slope_x, *slope_y, *sigma;  // disparity NaN where no fit holds
};

void fitRowBase(const Images& images, const Limits& limits, int y, const Row& row);
void fitRowAvx2(const Images& images, const Limits& limits, int y, const Row& row);

}  // namespace facenav::stereo::subpixel
