#pragma once
// The inner loop of the prior's network: sums over taps and input channels, for rows of features whose
// channels lie side by side. Compiled twice (facenav/core/simd.h); the two differ by rounding alone.

#include <cstddef>

namespace facenav::segmentation::convolution {

constexpr int kBlock = 16;  // output channels worked on together; their number is a multiple of it
constexpr int kMostTaps = 27;

struct Task {
  const float* in;                  // first row; `inputs` values a row
  float* out;                       // first row; `outputs` values a row, overwritten
  const float* weights;             // [outputs / kBlock][taps][inputs][kBlock]
  int inputs, outputs, taps;        // taps <= kMostTaps
  std::ptrdiff_t shift[kMostTaps];  // offset of each tap, in rows
  std::ptrdiff_t rows;              // one after the other in memory
};

struct Kernel {
  void (*convolve)(const Task& task);
};

Kernel baseKernel();
Kernel avx2Kernel();
/// The fastest kernel that this processor runs.
const Kernel& kernel();

}  // namespace facenav::segmentation::convolution
