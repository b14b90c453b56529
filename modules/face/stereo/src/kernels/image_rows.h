#pragma once
// The rectified pair in the form that the "field" matcher's kernels read: raw pointers only (see
// facenav/core/simd.h).

#include <cstdint>

namespace facenav::stereo {

constexpr float kMiddle_grey = 128.0f;  // subtracted, so that sums of squares stay small

struct ImageRows {
  const float* left;              // grey levels
  const float* right;             // cubic B-spline coefficients along the rows, kMiddle_grey subtracted
  int left_stride, right_stride;  // in elements
  int width, height, right_width;
  int right_shift;  // column of the right image = x - disparity + right_shift
  const std::int32_t *left_first, *left_end, *right_first, *right_end;  // valid columns of each row
};

}  // namespace facenav::stereo
